#pragma once

// Puts JSON together: brackets, commas, quoted keys and the spaces between them. Values are given
// as they are in the text: a text in quotes (quoted_text.h), a number as real_text() writes it.

#include "persist/json/json_value.h"

#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

class JsonText {
public:
    // Appends to `text`, which must outlive it.
    explicit JsonText(std::string& text) : text_(text) {}

    void open(char bracket, Layout layout);
    void close(char bracket);
    // What is appended next is the value. The key of a list's item is empty.
    void begin_item(std::string_view key);
    void item(std::string_view key, std::string_view value);

private:
    struct Level {
        Layout layout;
        bool empty = true;
    };
    void begin_line();

    std::string& text_;
    std::vector<Level> levels_;
};

struct JsonMember {
    std::string key;
    std::string value;
};
using JsonMembers = std::vector<JsonMember>;

std::string json_object(const JsonMembers& members, Layout layout = Layout::kLine);
std::string json_list(const std::vector<std::string>& values, Layout layout = Layout::kLine);
inline std::string json_truth(bool truth) {
    return truth ? "true" : "false";
}

}  // namespace cambrian
