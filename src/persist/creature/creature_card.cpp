#include "persist/creature/creature_card.h"

#include "core/files/file_io.h"
#include "persist/creature/png_file.h"
#include "persist/json/json_value.h"

#include <fmt/core.h>

#include <vector>

namespace cambrian {
namespace {

const PngLimits kCardLimits{.text_bytes = JsonLimits{}.bytes};

// Number of bytes that a message shows of a file that is not a picture.
constexpr std::size_t kLongestSignature = 8;

constexpr const char* kExpected =
    "expected a creature card: a PNG picture of at most 4096 x 4096 pixels that carries one "
    "creature of at most 4.0 MB";

Error refusal(std::string_view source, const std::string& reason) {
    return Error{fmt::format("{}: {}; {}", source, reason, kExpected)};
}

}  // namespace

Result<std::string> encode_card(const Image& picture, std::string_view document) {
    return encode_png(picture, {{std::string(kCardKeyword), std::string(document)}});
}

Status save_card(const std::filesystem::path& path, const Image& picture,
                 std::string_view document) {
    const Result<std::string> bytes = encode_card(picture, document);
    return bytes ? write_file(path, *bytes) : Status(bytes.error());
}

Result<bool> is_card(const std::filesystem::path& path) {
    const Result<std::string> start = read_start(path, kLongestSignature);
    if (!start) return start.error();
    return is_png(*start);
}

Result<std::string> card_document(std::string_view bytes, std::string_view source) {
    if (bytes.size() > kMaxCardBytes) return refusal(source, "a picture of over 16 MB");
    Result<std::vector<std::string>> texts = png_texts(bytes, kCardKeyword, kCardLimits);
    if (!texts) return refusal(source, "the picture cannot be read: " + texts.error().message);
    if (texts->empty()) return refusal(source, "a picture without a creature inside");
    if (texts->size() > 1)
        return refusal(source, fmt::format("{} creatures in one picture", texts->size()));
    return std::move(texts->front());
}

}  // namespace cambrian
