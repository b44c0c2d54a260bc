#include "cluster/messages/message_text.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr std::size_t kLongestFormat = 32;
constexpr double kMostVersion = 1e6;

}  // namespace

std::optional<JsonValue> parse_object(std::string_view text, const JsonLimits& limits,
                                      ErrorList& errors) {
    std::optional<JsonValue> root = parse_json(text, limits, errors);
    if (root && root->kind != JsonValue::Kind::kObject)
        errors.error("E06", "", std::string("expected an object, found ") + root->kind_in_words());
    return root;
}

int read_version(JsonReader& reader, std::string_view format, ErrorList& errors) {
    std::string found;
    int version = 0;
    reader.text("format", found, kLongestFormat);
    if (errors.empty() && found != format)
        errors.error("E03", "/format",
                     fmt::format("this is a {}, expected {}", in_quotes(found), in_quotes(format)));
    if (errors.empty()) reader.integer("version", version, 1.0, kMostVersion);
    return version;
}

bool read_kind(JsonReader& reader, const MessageKind& kind, ErrorList& errors) {
    const int version = read_version(reader, kind.format, errors);
    if (errors.empty() && version != kind.version)
        errors.error("E04", "/version",
                     fmt::format("expected {}, found {}", kind.version, version));
    return errors.empty();
}

}  // namespace cambrian
