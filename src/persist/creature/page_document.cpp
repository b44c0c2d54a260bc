#include "persist/creature/page_document.h"

#include "core/text/search_words.h"
#include "persist/json/json_value.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr std::string_view kBeginning = "<!doctype html";

}  // namespace

bool is_page(std::string_view start) {
    return small_letters(std::string(start.substr(0, kBeginning.size()))) == kBeginning;
}

Result<std::string> page_document(std::string_view bytes, std::string_view source) {
    const auto refusal = [&](std::string_view reason) {
        return Error{
            fmt::format("{}: {}; expected a page made by `cambrian page`, of at most 64 MB, "
                        "with a creature of at most 4.0 MB",
                        source, reason)};
    };
    if (bytes.size() > kMaxPageBytes) return refusal("a page of over 64 MB");
    const std::string opening =
        fmt::format("<script type=\"application/json\" id=\"{}\">", kCreatureElement);
    const std::size_t found = bytes.find(opening);
    if (found == std::string_view::npos) return refusal("a page without a creature inside");
    const std::size_t begin = found + opening.size();
    const std::size_t end = bytes.find("</script>", begin);
    if (end == std::string_view::npos) return refusal("the creature inside is cut off");
    if (end - begin > JsonLimits{}.bytes) return refusal("the creature inside is too large");
    return std::string(bytes.substr(begin, end - begin));
}

}  // namespace cambrian
