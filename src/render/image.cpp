#ifndef __clang_analyzer__  // the library is not ours to analyse
#define STB_IMAGE_WRITE_IMPLEMENTATION
#endif
#define STB_IMAGE_WRITE_STATIC
#include "render/image.h"

#include "render/gl.h"

#include <algorithm>
#include <cstddef>
#include <stb/stb_image_write.h>

namespace cambrian {

Image read_pixels(int width, int height) {
    const auto row = static_cast<std::size_t>(width) * 3;
    Image image{width, height, std::vector<std::uint8_t>(row * static_cast<std::size_t>(height))};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
    // OpenGL's rows begin at the bottom.
    for (int low = 0, high = height - 1; low < high; ++low, --high) {
        const auto first = image.rgb.begin() + static_cast<std::ptrdiff_t>(row) * low;
        const auto last = image.rgb.begin() + static_cast<std::ptrdiff_t>(row) * high;
        std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(row), last);
    }
    return image;
}

std::string encode_png(const Image& image) {
    std::string bytes;
    const auto append = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                                   static_cast<std::size_t>(size));
    };
    stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.rgb.data(),
                           image.width * 3);
    return bytes;
}

}  // namespace cambrian
