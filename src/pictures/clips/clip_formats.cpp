#include "core/text/number_text.h"
#include "pictures/clips/clip_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace cambrian {

std::span<const ClipFormat> clip_formats() {
    static const std::array formats = {gif_format(), mp4_format(), moving_png_format()};
    return formats;
}

const ClipFormat* clip_format_of(const std::filesystem::path& path) {
    const std::span<const ClipFormat> formats = clip_formats();
    const auto format = std::find_if(formats.begin(), formats.end(), [&](const ClipFormat& each) {
        return path.extension() == each.ending;
    });
    return format == formats.end() ? nullptr : &*format;
}

const ClipFormat& card_format() {
    static const ClipFormat format = moving_png_format();
    return format;
}

Status check_clip(const ClipFormat& format, const std::filesystem::path& path, int width,
                  int height, double frames_a_second) {
    if (format.even_sides && (width % 2 != 0 || height % 2 != 0)) {
        return Error{path.string() +
                     ": clips of this format must be an even number of pixels wide "
                     "and high"};
    }
    if (frames_a_second <= format.most_rate) return {};
    return Error{fmt::format("{}: a {} shows at most {} frames a second, found {}; {}",
                             path.string(), format.label, short_text(format.most_rate),
                             short_text(frames_a_second), format.slowness)};
}

}  // namespace cambrian
