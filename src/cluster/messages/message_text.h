#pragma once

// The common form of messages: one JSON object on one line, which begins with the kind and version
// of the message.

#include "core/result.h"
#include "persist/json/json_reader.h"
#include "persist/json/json_writer.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr std::size_t kLongestVersion = 32;  // bytes, of a simulator's version
// Largest index of a creature in its generation.
inline constexpr double kMostSlot = 4'294'967'295.0;

struct MessageKind {
    std::string format;  // "cambrian-unit"
    int version = 1;
};

// Parses the object of a message; reports an error if there is none or if a key is duplicated.
std::optional<JsonValue> parse_object(std::string_view text, const JsonLimits& limits,
                                      ErrorList& errors);

// Returns the version of a message of that format; reports an error for another format.
int read_version(JsonReader& reader, std::string_view format, ErrorList& errors);

// Returns whether the object is such a message; otherwise reports what it is.
bool read_kind(JsonReader& reader, const MessageKind& kind, ErrorList& errors);

template <class Message, class Describe>
std::string write_message(const MessageKind& kind, Message& message, Describe describe) {
    std::string text;
    JsonWriter writer(text, JsonLayout::kCompact);
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
    JsonReader reader(*root, {}, errors);
    Message message;
    if (read_kind(reader, kind, errors)) describe(reader, message);
    if (!errors.empty()) return errors.as_error(kind.format);
    return message;
}

}  // namespace cambrian
