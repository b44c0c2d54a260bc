#include "app/command_line/picture_size.h"

#include "core/text/parsed_number.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace cambrian {
namespace {

constexpr int kLeastSide = 64;  // pixels
constexpr int kMostSide = 4096;

}  // namespace

std::optional<PictureSides> parse_picture_size(const std::string& text) {
    const std::string_view both = text;
    const std::size_t cross = std::min(both.find('x'), both.size());
    const auto width = parsed_number<int>(both.substr(0, cross));
    const auto height = parsed_number<int>(both.substr(std::min(cross + 1, both.size())));
    const auto possible = [](int side) { return side >= kLeastSide && side <= kMostSide; };
    if (!width || !height || !possible(*width) || !possible(*height)) return std::nullopt;
    return PictureSides{*width, *height};
}

std::string check_picture_size(const std::string& text) {
    if (parse_picture_size(text)) return "";
    return fmt::format(
        "'{}' is not a size; expected WIDTHxHEIGHT in pixels, each {} to {}, as 1280x720", text,
        kLeastSide, kMostSide);
}

}  // namespace cambrian
