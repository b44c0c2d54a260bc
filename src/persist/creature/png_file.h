#pragma once

// PNG pictures, and texts inside them. The only place that knows libpng.

#include "core/image.h"
#include "core/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// A text chunk: UTF-8 under a keyword of Latin letters (1 to 79 of them).
struct PngText {
    std::string keyword;
    std::string text;
};

// The bytes of a PNG file; the texts come before the pixels, compressed.
Result<std::string> encode_png(const Image& image, const std::vector<PngText>& texts = {});

// Whether a file with these bytes at its start says that it is a PNG picture.
bool is_png(std::string_view bytes);

struct PngLimits {
    int side = 4096;                     // pixels; of a picture wide or high
    std::size_t text_bytes = 4'000'000;  // of one text, unpacked
    int chunks = 12;                     // texts and the like; bounds the memory they take
};

// Returns all texts of a picture under a keyword. It reads the picture to its end, and fails with
// libpng's message if that is truncated, damaged or beyond the limits.
Result<std::vector<std::string>> png_texts(std::string_view bytes, std::string_view keyword,
                                           const PngLimits& limits = {});

}  // namespace cambrian
