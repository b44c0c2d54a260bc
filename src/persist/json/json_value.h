#pragma once

// JSON as plain values in the order of the file. The parser is strict and bounded: it refuses
// duplicate keys, deep nesting and more values than any of our files needs.

#include "persist/text/error_list.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

struct JsonValue {
    enum class Kind : std::uint8_t { kNull, kFlag, kInteger, kReal, kText, kList, kObject };

    Kind kind = Kind::kNull;
    bool flag = false;
    double number = 0.0;  // integer or real; finite
    std::string text;
    std::vector<std::string> keys;  // of an object, one per value
    std::vector<JsonValue> values;  // of an object or list

    const JsonValue* find(std::string_view key) const;
    // Returns "a number", "a text" and so on, for messages.
    const char* kind_in_words() const;
};

// The layout of an object or a list in text. One inside an object or a list not kLines has the
// layout of that one.
enum class JsonLayout : std::uint8_t {
    kLines,    // one value per line, indented by two spaces
    kCompact,  // { "a": 1, "b": 2 }
    kLine,     // {"a": 1, "b": 2}
    kDense     // {"a":1,"b":2}
};

// Names of values for which older files have numbers.
struct NumberedNames {
    static constexpr int kMost = 255;  // the largest number; no name has it

    std::vector<std::string> names;     // indexed by value
    std::vector<std::string> numbered;  // indexed by number
};

struct JsonLimits {
    std::size_t bytes = 4'000'000;
    std::size_t depth = 32;
    std::size_t values = 100'000;
    std::size_t keys = 256;  // largest number of keys in one object
};

// Returns the document, or nothing if it cannot be read; `errors` says why (E01, E02, E07, E10).
// Duplicate keys of a readable document are errors too (E13).
std::optional<JsonValue> parse_json(std::string_view text, const JsonLimits& limits,
                                    ErrorList& errors);

}  // namespace cambrian
