#pragma once

// Draws text into images without a graphics card.

#include "core/image.h"
#include "core/result.h"
#include "pictures/canvas/typefaces.h"
#include "render/color.h"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace cambrian {

// Draws text in the regular and the strong typeface, and letters that these lack in others.
class TextRasterizer {
public:
    // Fails if no typeface is installed.
    static Result<std::unique_ptr<TextRasterizer>> load();
    // Returns whether the outlines of a font file can be read.
    static bool can_read(const FontFile& file);
    ~TextRasterizer();
    TextRasterizer(const TextRasterizer&) = delete;
    TextRasterizer& operator=(const TextRasterizer&) = delete;

    // Returns the width of a text in pixels; `size` is the height of a line.
    double width(std::string_view text, Typeface typeface, double size) const;
    // Draws text; x, y is the left end of the baseline. Parts outside the image are not drawn.
    void draw(Image& image, double x, double y, std::string_view text, Typeface typeface,
              double size, const Color& color) const;

    // Returns the text, shortened with an ellipsis to the width `most`.
    std::string fit(std::string_view text, Typeface typeface, double size, double most) const;

private:
    struct Face;

    TextRasterizer();
    const Face& face(Typeface typeface) const {
        return *faces_[static_cast<std::size_t>(typeface)];
    }

    std::array<std::unique_ptr<Face>, 2> faces_;  // indexed by Typeface
};

}  // namespace cambrian
