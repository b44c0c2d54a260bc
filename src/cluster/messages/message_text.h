#pragma once

// What all messages share: one JSON object on one line, which says first which kind of message it
// is and of which version.

#include "core/result.h"
#include "persist/json/json_reader.h"
#include "persist/json/json_writer.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr std::size_t kLongestVersion = 32;    // bytes, of a simulator's version
inline constexpr double kMostSlot = 4'294'967'295.0;  // of a creature in its generation

struct MessageKind {
    std::string format;  // "cambrian-unit"
    int version = 1;
};

// The object that a message is; if it is none or holds a key twice, `errors` says so.
std::optional<JsonValue> parse_object(std::string_view text, const JsonLimits& limits,
                                      ErrorList& errors);

// The version of a message of that format, whatever it is; an error if it is of another format.
int read_version(JsonReader& reader, std::string_view format, ErrorList& errors);

// Whether the object is such a message; says what it is otherwise.
bool read_kind(JsonReader& reader, const MessageKind& kind, ErrorList& errors);

template <class Message, class Describe>
std::string write_message(const MessageKind& kind, Message& message, Describe describe) {
    std::string text;
    JsonWriter writer(text, Layout::kCompact);
    writer.text("format", kind.format, kind.format.size());
    writer.integer("version", kind.version, kind.version, kind.version);
    describe(writer, message);
    writer.end();
    return text;
}

template <class Message, class Describe>
Result<Message> read_message(const MessageKind& kind, std::string_view text,
                             const JsonLimits& limits, Describe describe) {
    ErrorList errors;
    const std::optional<JsonValue> root = parse_object(text, limits, errors);
    if (!errors.empty()) return errors.as_error(kind.format);
    JsonReader reader(*root, "", errors);
    Message message;
    if (read_kind(reader, kind, errors)) describe(reader, message);
    if (!errors.empty()) return errors.as_error(kind.format);
    return message;
}

}  // namespace cambrian
