#include "persist/json/json_reader.h"

#include "core/text/nearest_name.h"
#include "core/text/number_text.h"
#include "genome/gene_fields.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kLargestWhole = 9e15;  // larger doubles may not be exact integers
constexpr double kAnySize = 1e300;

std::string range_message(double number, double low, double high, bool open = false) {
    return fmt::format("{} is outside [{}, {}{}", short_text(number), short_text(low),
                       short_text(high), open ? ")" : "]");
}

// In JSON, 15 and 15.0 are the same number, so integer settings accept both.
bool is_whole(const SettingRef& place) {
    return std::holds_alternative<int*>(place) || std::holds_alternative<std::uint64_t*>(place);
}

SettingValue setting_value(const JsonValue& value, bool whole) {
    switch (value.kind) {
        case JsonValue::Kind::kFlag:
            return value.flag;
        case JsonValue::Kind::kReal:
        case JsonValue::Kind::kInteger: {
            const bool as_integer = whole && value.number == std::floor(value.number) &&
                                    std::fabs(value.number) <= kLargestWhole;
            if (as_integer) return static_cast<std::int64_t>(value.number);
            return value.number;
        }
        case JsonValue::Kind::kText:
            return value.text;
        default:
            return {};
    }
}

const char* code_of(SettingFault fault) {
    if (fault == SettingFault::kType) return "E06";
    return fault == SettingFault::kRange ? "E07" : "E08";
}

}  // namespace

std::string JsonPlace::pointer() const {
    if (parent == nullptr) return {};
    const std::string before = parent->pointer();
    return index ? fmt::format("{}/{}", before, *index) : fmt::format("{}/{}", before, key);
}

void JsonReader::end() {
    for (const std::string& key : object_.keys) {
        if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
        const std::string near = nearest_name(key, known_);
        errors_.warn("W01", pointer(shown(key)),
                     near.empty()
                         ? "unknown key, ignored"
                         : fmt::format("unknown key, ignored; did you mean \"{}\"?", near));
    }
}

void JsonReader::wrong_type(const JsonPlace& where, const char* expected, const JsonValue& found) {
    const std::string what =
        found.kind == Kind::kText ? in_quotes(found.text) : found.kind_in_words();
    errors_.error("E06", where.pointer(), fmt::format("expected {}, found {}", expected, what));
}

const JsonValue* JsonReader::member(const char* key, Kind kind, const char* expected) {
    known_.emplace_back(key);
    const JsonValue* value = object_.find(key);
    if (value == nullptr) {
        errors_.error("E05", pointer(key), "missing");
        return nullptr;
    }
    const bool number = kind == Kind::kReal && value->kind == Kind::kInteger;
    if (value->kind == kind || number) return value;
    wrong_type(place(key), expected, *value);
    return nullptr;
}

const JsonValue* JsonReader::number_member(const char* key, const char* expected) {
    return member(key, Kind::kReal, expected);
}

bool JsonReader::check_real(const JsonPlace& where, const JsonValue& value, const FieldRule& rule) {
    if (value.kind != Kind::kReal && value.kind != Kind::kInteger) {
        wrong_type(where, "a number", value);
        return false;
    }
    if (in_range(value.number, rule)) return true;
    if (rule.whole && value.number != std::floor(value.number)) {
        errors_.error("E06", where.pointer(),
                      "expected a whole number, found " + short_text(value.number));
        return false;
    }
    errors_.error("E07", where.pointer(),
                  range_message(value.number, rule.low, rule.high, rule.wraps));
    return false;
}

void JsonReader::real(const char* key, double& value, const FieldRule& rule) {
    const JsonValue* number = number_member(key, "a number");
    if (number != nullptr && check_real(place(key), *number, rule)) value = number->number;
}

void JsonReader::plain_real(const char* key, double& value) {
    const JsonValue* number = number_member(key, "a number");
    if (number != nullptr) value = number->number;
}

void JsonReader::pair(const char* key, double& first, const FieldRule& first_rule, double& second,
                      const FieldRule& second_rule) {
    const JsonValue* both = member(key, Kind::kList, "a list of 2 numbers");
    if (both == nullptr) return;
    if (both->values.size() != 2) {
        errors_.error(
            "E06", pointer(key),
            fmt::format("expected a list of 2 numbers, found one of {}", both->values.size()));
        return;
    }
    const JsonPlace list = place(key);
    if (check_real(entry(list, 0), both->values[0], first_rule)) first = both->values[0].number;
    if (check_real(entry(list, 1), both->values[1], second_rule)) second = both->values[1].number;
}

std::optional<double> JsonReader::whole_number(const char* key, double low, double high) {
    const JsonValue* value = number_member(key, "a whole number");
    if (value == nullptr) return std::nullopt;
    if (value->number != std::floor(value->number)) {
        errors_.error("E06", pointer(key),
                      "expected a whole number, found " + short_text(value->number));
        return std::nullopt;
    }
    if (value->number >= low && value->number <= high) return value->number;
    errors_.error("E07", pointer(key), range_message(value->number, low, high));
    return std::nullopt;
}

std::optional<double> JsonReader::index_number(const char* key, std::size_t count,
                                               const char* of_what) {
    const auto number = whole_number(key, -kAnySize, kAnySize);
    if (!number || (*number >= 0.0 && *number < static_cast<double>(count))) return number;
    errors_.error("E09", pointer(key),
                  fmt::format("{}, but there are {} {}", short_text(*number), count, of_what));
    return std::nullopt;
}

void JsonReader::flag(const char* key, bool& value) {
    const JsonValue* found = member(key, Kind::kFlag, "true or false");
    if (found != nullptr) value = found->flag;
}

std::optional<std::size_t> JsonReader::choice_index(const char* key,
                                                    std::span<const std::string> names,
                                                    const char* what) {
    const JsonValue* value = member(key, Kind::kText, "a text");
    if (value == nullptr) return std::nullopt;
    const auto found = std::find(names.begin(), names.end(), value->text);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    const std::string near = nearest_name(value->text, names);
    std::string message = fmt::format("unknown {} {}", what, in_quotes(value->text));
    if (!near.empty()) message += fmt::format("; did you mean \"{}\"?", near);
    errors_.error("E08", pointer(key), message);
    return std::nullopt;
}

std::optional<std::size_t> JsonReader::numbered_index(const char* key, const NumberedNames& names,
                                                      const char* what) {
    const JsonValue* value = object_.find(key);
    if (value != nullptr && value->kind == Kind::kText) return choice_index(key, names.names, what);
    const auto number = whole_number(key, 0.0, NumberedNames::kMost);
    if (!number) return std::nullopt;
    const auto index = static_cast<std::size_t>(*number);
    if (index < names.numbered.size()) {
        const auto found = std::find(names.names.begin(), names.names.end(), names.numbered[index]);
        if (found != names.names.end())
            return static_cast<std::size_t>(found - names.names.begin());
    }
    return index < names.names.size() ? std::size_t{NumberedNames::kMost} : index;
}

bool JsonReader::check_size(const JsonPlace& where, const std::string& text,
                            std::size_t max_bytes) {
    if (text.size() <= max_bytes) return true;
    errors_.error("E10", where.pointer(),
                  fmt::format("{} bytes, limit {}", text.size(), max_bytes));
    return false;
}

void JsonReader::text(const char* key, std::string& value, std::size_t max_bytes) {
    const JsonValue* found = member(key, Kind::kText, "a text");
    if (found != nullptr && check_size(place(key), found->text, max_bytes)) value = found->text;
}

const JsonValue* JsonReader::sized_list(const char* key, std::size_t low, std::size_t high) {
    const JsonValue* list = member(key, Kind::kList, "a list");
    if (list == nullptr) return nullptr;
    const std::size_t size = list->values.size();
    if (size >= low && size <= high) return list;
    errors_.error("E10", pointer(key),
                  size < low ? fmt::format("{} entries, at least {}", size, low)
                             : fmt::format("{} entries, limit {}", size, high));
    return nullptr;
}

void JsonReader::texts(const char* key, std::vector<std::string>& values, std::size_t max_count,
                       std::size_t max_bytes) {
    const JsonValue* list = sized_list(key, 0, max_count);
    if (list == nullptr) return;
    const JsonPlace place_of_list = place(key);
    for (std::size_t i = 0; i < list->values.size(); ++i) {
        const JsonValue& each = list->values[i];
        const JsonPlace where = entry(place_of_list, i);
        if (each.kind != Kind::kText) {
            wrong_type(where, "a text", each);
        } else if (check_size(where, each.text, max_bytes)) {
            values.push_back(each.text);
        }
    }
}

void JsonReader::digest(const char* key, std::uint64_t& value) {
    const char* const expected = "\"fnv1a64:\" and 16 hexadecimal digits";
    const JsonValue* found = member(key, Kind::kText, expected);
    if (found == nullptr) return;
    const auto parsed = parse_digest(found->text);
    if (!parsed) return wrong_type(place(key), expected, *found);
    value = *parsed;
}

void JsonReader::optional_bytes(const char* key, std::vector<std::uint8_t>& bytes,
                                std::size_t line_bytes, std::size_t max_bytes) {
    if (!has(key)) return;
    const JsonValue* list = sized_list(key, 1, lines_of(max_bytes, line_bytes));
    if (list == nullptr) return;
    const std::string expected =
        fmt::format("1 to {} pairs of hexadecimal digits 0 to f", line_bytes);
    for (std::size_t i = 0; i < list->values.size(); ++i) {
        const JsonValue& each = list->values[i];
        const auto line = each.kind == Kind::kText ? parse_hex_pairs(each.text) : std::nullopt;
        if (!line || line->empty() || line->size() > line_bytes)
            return wrong_type(entry(place(key), i), expected.c_str(), each);
        bytes.insert(bytes.end(), line->begin(), line->end());
    }
}

void JsonReader::setting(const SettingField& field, ExperimentSettings& settings) {
    known_.push_back(field.key);
    const JsonValue* value = object_.find(field.key);
    if (value == nullptr) return;
    const SettingCheck check =
        assign(field, setting_value(*value, is_whole(field.at(settings))), settings);
    if (check.fault != SettingFault::kNone)
        errors_.error(code_of(check.fault), pointer(field.key), check.message);
}

}  // namespace cambrian
