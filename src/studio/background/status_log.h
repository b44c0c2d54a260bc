#pragma once

// A log of events, one JSON object per line, flushed at once. Tests that drive the window from
// outside wait for these events. Each event has the number of its frame in the frame log, except
// those before the first frame.

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

    // An empty path, or one that cannot be opened, disables the log.
    explicit StatusLog(const std::filesystem::path& path);
    // Sets the number of the frame to which the following events belong.
    void begin_frame(std::uint64_t number) { frame_ = number; }
    void write(const std::string& event, std::initializer_list<Field> fields = {});

private:
    std::ofstream file_;
    std::uint64_t frame_ = 0;
};

}  // namespace cambrian
