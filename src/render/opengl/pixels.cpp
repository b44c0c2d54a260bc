#include "render/opengl/pixels.h"

#include "render/opengl/gl.h"

#include <algorithm>
#include <cstddef>

namespace cambrian {

Image read_pixels(int width, int height) {
    const auto row = static_cast<std::size_t>(width) * 3;
    Image image{width, height, std::vector<std::uint8_t>(row * static_cast<std::size_t>(height))};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
    // OpenGL stores the bottom row first.
    for (int low = 0, high = height - 1; low < high; ++low, --high) {
        const auto first = image.rgb.begin() + static_cast<std::ptrdiff_t>(row) * low;
        const auto last = image.rgb.begin() + static_cast<std::ptrdiff_t>(row) * high;
        std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(row), last);
    }
    return image;
}

}  // namespace cambrian
