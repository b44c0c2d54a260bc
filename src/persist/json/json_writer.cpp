#include "persist/json/json_writer.h"

#include "core/text/number_text.h"
#include "persist/text/digest_text.h"

#include <algorithm>

namespace cambrian {

void JsonWriter::real(const char* key, double value, const FieldRule& /*rule*/) {
    plain_real(key, value);
}

void JsonWriter::plain_real(const char* key, double value) {
    item(key, real_text(value));
}

void JsonWriter::pair(const char* key, double first, const FieldRule& /*first_rule*/, double second,
                      const FieldRule& /*second_rule*/) {
    item(key, "[" + real_text(first) + ", " + real_text(second) + "]");
}

void JsonWriter::texts(const char* key, const std::vector<std::string>& values,
                       std::size_t /*max_count*/, std::size_t /*max_bytes*/) {
    std::string joined = "[";
    for (const std::string& value : values) {
        if (joined.size() > 1) joined += ", ";
        joined += quoted_text(value);
    }
    item(key, joined + "]");
}

void JsonWriter::digest(const char* key, std::uint64_t value) {
    item(key, quoted_text(digest_text(value)));
}

void JsonWriter::optional_bytes(const char* key, std::span<const std::uint8_t> bytes,
                                std::size_t line_bytes, std::size_t /*max_bytes*/) {
    if (bytes.empty()) return;
    begin_item(key);
    open('[', Layout::kLines);
    for (std::size_t start = 0; start < bytes.size(); start += line_bytes) {
        begin_item("");
        const auto line = bytes.subspan(start, std::min(line_bytes, bytes.size() - start));
        text_ += quoted_text(hex_pairs(line));
    }
    close(']');
}

void JsonWriter::open(char bracket, Layout layout) {
    const bool compact = layout == Layout::kCompact ||
                         (!levels_.empty() && levels_.back().layout == Layout::kCompact);
    text_ += bracket;
    levels_.push_back({compact ? Layout::kCompact : Layout::kLines});
}

void JsonWriter::close(char bracket) {
    const Level level = levels_.back();
    levels_.pop_back();
    if (!level.empty && level.layout == Layout::kCompact) text_ += ' ';
    if (!level.empty && level.layout == Layout::kLines) {
        text_ += '\n';
        text_.append(2 * levels_.size(), ' ');
    }
    text_ += bracket;
}

void JsonWriter::begin_item(std::string_view key) {
    Level& level = levels_.back();
    if (!level.empty) text_ += ',';
    if (level.layout == Layout::kLines) {
        text_ += '\n';
        text_.append(2 * levels_.size(), ' ');
    } else {
        text_ += ' ';
    }
    level.empty = false;
    if (!key.empty()) text_ += quoted_text(key) + ": ";
}

void JsonWriter::item(std::string_view key, std::string_view value) {
    begin_item(key);
    text_ += value;
}

}  // namespace cambrian
