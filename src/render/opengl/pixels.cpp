#include "render/opengl/pixels.h"

#include "render/opengl/gl.h"

#include <algorithm>
#include <cstddef>

namespace cambrian {

Image read_pixels(int width, int height) {
    return read_pixels({0, 0, width, height});
}

Image read_pixels(const ReadArea& area) {
    const auto row = static_cast<std::size_t>(area.width) * 3;
    Image image{area.width, area.height,
                std::vector<std::uint8_t>(row * static_cast<std::size_t>(area.height))};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(area.left, area.low, area.width, area.height, GL_RGB, GL_UNSIGNED_BYTE,
                 image.rgb.data());
    // OpenGL stores the bottom row first.
    for (int low = 0, high = area.height - 1; low < high; ++low, --high) {
        const auto first = image.rgb.begin() + static_cast<std::ptrdiff_t>(row) * low;
        const auto last = image.rgb.begin() + static_cast<std::ptrdiff_t>(row) * high;
        std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(row), last);
    }
    return image;
}

Image read_scaled(const ReadArea& area, const Framebuffer& scaled) {
    const GLboolean scissors = glIsEnabled(GL_SCISSOR_TEST);
    glDisable(GL_SCISSOR_TEST);
    scaled.bind();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glBlitFramebuffer(area.left, area.low, area.left + area.width, area.low + area.height, 0, 0,
                      scaled.width(), scaled.height(), GL_COLOR_BUFFER_BIT, GL_LINEAR);
    scaled.bind();
    Image image = read_pixels(scaled.width(), scaled.height());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (scissors == GL_TRUE) glEnable(GL_SCISSOR_TEST);
    return image;
}

}  // namespace cambrian
