#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian {

// A picture with rows from the top and three bytes per pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;

    // Returns red, green and blue of a pixel, which must be inside the image.
    std::uint8_t* pixel(int x, int y) { return rgb.data() + 3 * index(x, y); }
    const std::uint8_t* pixel(int x, int y) const { return rgb.data() + 3 * index(x, y); }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

}  // namespace cambrian
