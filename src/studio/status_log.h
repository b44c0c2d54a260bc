#pragma once

// What happened, one JSON object a line, written at once: for tests that drive the window from
// outside and wait for what follows.

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
    void write(const std::string& event, std::initializer_list<Field> fields = {});

private:
    std::ofstream file_;
};

// The text as JSON writes it, quotes included.
std::string json_text(const std::string& text);

}  // namespace cambrian
