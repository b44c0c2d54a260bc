#pragma once

// What happened, one JSON object a line, written at once: for tests that drive the window from
// outside and wait for what follows. Each tells its frame, as numbered in the frame log, unless it
// comes before the first.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>

namespace cambrian {

class StatusLog {
public:
    using Value = std::variant<std::string, double, bool>;
    using Field = std::pair<const char*, Value>;

    // Nothing is written if the path is empty or cannot be opened.
    explicit StatusLog(const std::filesystem::path& path);
    // What is written from now on belongs to this frame.
    void begin_frame(std::uint64_t number) { frame_ = number; }
    void write(const std::string& event, std::initializer_list<Field> fields = {});

private:
    std::ofstream file_;
    std::uint64_t frame_ = 0;
};

}  // namespace cambrian
