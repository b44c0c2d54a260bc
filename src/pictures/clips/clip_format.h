#pragma once

// The formats of clips. A format is a file here and a line in clip_formats.cpp; the command line
// and the studio offer those in the list.

#include "core/image.h"
#include "core/result.h"
#include "pictures/clips/color_table.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace cambrian {

// All that is known of a clip before its first picture.
struct ClipPlan {
    std::filesystem::path path;
    int width = 0;  // pixels
    int height = 0;
    double frames_a_second = 30.0;
    std::uint64_t frames = 0;
    const ColorCensus* colors = nullptr;  // of some of its pictures; for formats with few colours
    bool dithered = false;                // whether those mix them
    std::string creature = {};  // the creature file that the clip embeds, if its format can
};

// Writes a clip beside its target, which it replaces at finish(); without that, nothing is left.
class ClipEncoder {
public:
    virtual ~ClipEncoder() = default;
    // Adds a picture of the clip's size. All of the planned number must be added.
    virtual Status add(const Image& picture) = 0;
    virtual Status finish() = 0;
};

struct ClipFormat {
    std::string_view ending;  // ".gif"
    std::string_view label;   // "GIF"
    int usual_width = 0;      // pixels
    int usual_height = 0;
    double usual_rate = 0.0;         // Hz
    double most_rate = 0.0;          // Hz; the most pictures a second that players show
    std::string_view slowness = {};  // what they do with more, as a clause
    bool even_sides = false;         // whether width and height must be even
    bool few_colors = false;         // whether it needs a census of colours
    bool embeds = false;             // whether it can hold a creature file
    // Returns why it cannot be written here, as a sentence without a full stop; empty if it can.
    std::string (*missing)() = [] { return std::string(); };
    Result<std::unique_ptr<ClipEncoder>> (*open)(const ClipPlan& plan) = nullptr;
};

ClipFormat gif_format();
ClipFormat moving_png_format();
ClipFormat mp4_format();

std::span<const ClipFormat> clip_formats();
// Returns the format that a name's ending means; null for other names.
const ClipFormat* clip_format_of(const std::filesystem::path& path);

// Fails if a format cannot show so many pictures a second (Hz) of that size; `path` is named.
Status check_clip(const ClipFormat& format, const std::filesystem::path& path, int width,
                  int height, double frames_a_second);
// The format of creature cards that move.
const ClipFormat& card_format();

}  // namespace cambrian
