#pragma once

// Writes the brackets, commas, quoted keys and spaces of JSON. Callers give values as they are in
// the text: strings by quoted_text(), numbers by real_text().

#include "persist/json/json_value.h"

#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

class JsonText {
public:
    // Everything is appended to `text`, which must outlive this object.
    explicit JsonText(std::string& text) : text_(text) {}

    void open(char bracket, JsonLayout layout);
    void close(char bracket);
    // Writes the comma, the space and the key before a value. The key of a list's item is empty.
    void begin_item(std::string_view key);
    void item(std::string_view key, std::string_view value);

private:
    struct Level {
        JsonLayout layout;
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

std::string json_object(const JsonMembers& members, JsonLayout layout = JsonLayout::kLine);
std::string json_list(const std::vector<std::string>& values,
                      JsonLayout layout = JsonLayout::kLine);
inline std::string json_truth(bool truth) {
    return truth ? "true" : "false";
}

}  // namespace cambrian
