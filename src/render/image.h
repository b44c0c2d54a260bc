#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

// Rows from the top, three bytes a pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

// The pixels of the bound framebuffer's lower left width x height corner. Waits for the graphics
// card.
Image read_pixels(int width, int height);

// The bytes of a PNG file.
std::string encode_png(const Image& image);

}  // namespace cambrian
