#pragma once

// Sizes of pictures as they are typed.

#include <optional>
#include <string>

namespace cambrian {

// In pixels.
struct PictureSides {
    int width = 0;
    int height = 0;
};

// Parses "1280x720"; returns nothing for other text and for sizes that cannot be drawn.
std::optional<PictureSides> parse_picture_size(const std::string& text);

// Returns what is wrong with such a text, or nothing.
std::string check_picture_size(const std::string& text);

}  // namespace cambrian
