#pragma once

// PNG pictures and the texts inside them. Only this file uses libpng.

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

// Returns the bytes of a PNG file. Texts come before the pixels and are compressed.
Result<std::string> encode_png(const Image& image, const std::vector<PngText>& texts = {});

// Returns whether a file that begins with these bytes is a PNG picture.
bool is_png(std::string_view bytes);

struct PngLimits {
    int side = 4096;                     // pixels; largest width and height
    std::size_t text_bytes = 4'000'000;  // bytes of one uncompressed text
    int chunks = 12;  // largest number of text and other extra chunks; bounds their memory
};

// Returns the pixels of a picture on white, without its transparency. Fails with libpng's message
// if it is damaged, or if a side is beyond the limits; chunks are not looked at.
Result<Image> decode_png(std::string_view bytes, const PngLimits& limits = {});

// Returns all texts of a picture under a keyword. It reads the picture to its end, and fails with
// libpng's message if that is truncated, damaged or beyond the limits.
Result<std::vector<std::string>> png_texts(std::string_view bytes, std::string_view keyword,
                                           const PngLimits& limits = {});

}  // namespace cambrian
