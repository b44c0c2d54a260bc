#include "persist/json/json_writer.h"

#include "core/text/number_text.h"
#include "genome/field_rule.h"
#include "persist/text/digest_text.h"

#include <algorithm>

namespace cambrian {

void JsonWriter::real(const char* key, double value, const FieldRule& rule) {
    if (rule.whole) return integer(key, static_cast<int>(value), rule.low, rule.high);
    plain_real(key, value);
}

void JsonWriter::plain_real(const char* key, double value) {
    json_.item(key, real_text(value));
}

void JsonWriter::pair(const char* key, double first, const FieldRule& /*first_rule*/, double second,
                      const FieldRule& /*second_rule*/) {
    json_.item(key, json_list({real_text(first), real_text(second)}));
}

void JsonWriter::texts(const char* key, const std::vector<std::string>& values,
                       std::size_t /*max_count*/, std::size_t /*max_bytes*/) {
    std::vector<std::string> quoted;
    quoted.reserve(values.size());
    for (const std::string& value : values)
        quoted.push_back(quoted_text(value));
    json_.item(key, json_list(quoted));
}

void JsonWriter::digest(const char* key, std::uint64_t value) {
    json_.item(key, quoted_text(digest_text(value)));
}

void JsonWriter::optional_bytes(const char* key, std::span<const std::uint8_t> bytes,
                                std::size_t line_bytes, std::size_t /*max_bytes*/) {
    if (bytes.empty()) return;
    json_.begin_item(key);
    json_.open('[', JsonLayout::kLines);
    for (std::size_t start = 0; start < bytes.size(); start += line_bytes) {
        const auto line = bytes.subspan(start, std::min(line_bytes, bytes.size() - start));
        json_.item("", quoted_text(hex_pairs(line)));
    }
    json_.close(']');
}

}  // namespace cambrian
