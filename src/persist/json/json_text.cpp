#include "persist/json/json_text.h"

#include "persist/text/quoted_text.h"

namespace cambrian {

void JsonText::open(char bracket, JsonLayout layout) {
    const bool nested = !levels_.empty() && levels_.back().layout != JsonLayout::kLines;
    text_ += bracket;
    levels_.push_back({nested ? levels_.back().layout : layout});
}

void JsonText::close(char bracket) {
    const Level level = levels_.back();
    levels_.pop_back();
    if (!level.empty && level.layout == JsonLayout::kCompact) text_ += ' ';
    if (!level.empty && level.layout == JsonLayout::kLines) begin_line();
    text_ += bracket;
}

void JsonText::begin_item(std::string_view key) {
    Level& level = levels_.back();
    if (!level.empty) text_ += ',';
    if (level.layout == JsonLayout::kLines) {
        begin_line();
    } else if (level.layout == JsonLayout::kCompact ||
               (level.layout == JsonLayout::kLine && !level.empty)) {
        text_ += ' ';
    }
    level.empty = false;
    if (key.empty()) return;
    append_quoted(text_, key);
    text_ += level.layout == JsonLayout::kDense ? ":" : ": ";
}

void JsonText::item(std::string_view key, std::string_view value) {
    begin_item(key);
    text_ += value;
}

void JsonText::begin_line() {
    text_ += '\n';
    text_.append(2 * levels_.size(), ' ');
}

std::string json_object(const JsonMembers& members, JsonLayout layout) {
    std::string text;
    JsonText json(text);
    json.open('{', layout);
    for (const JsonMember& member : members)
        json.item(member.key, member.value);
    json.close('}');
    return text;
}

std::string json_list(const std::vector<std::string>& values, JsonLayout layout) {
    std::string text;
    JsonText json(text);
    json.open('[', layout);
    for (const std::string& value : values)
        json.item("", value);
    json.close(']');
    return text;
}

}  // namespace cambrian
