#pragma once

// Words in pictures, drawn without a graphics card.

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

// In the regular and the strong typeface.
class Lettering {
public:
    // Fails where no typeface is installed.
    static Result<std::unique_ptr<Lettering>> load();
    ~Lettering();
    Lettering(const Lettering&) = delete;
    Lettering& operator=(const Lettering&) = delete;

    // In pixels; `size` is the height of a line of letters.
    double width(std::string_view text, Typeface typeface, double size) const;
    // x, y: the left end of the base line. Letters outside the image are left out.
    void draw(Image& image, double x, double y, std::string_view text, Typeface typeface,
              double size, const Color& color) const;

    // Text cut off with an ellipsis to be at most so wide.
    std::string fit(std::string_view text, Typeface typeface, double size, double most) const;

private:
    struct Face;

    Lettering();
    const Face& face(Typeface typeface) const {
        return *faces_[static_cast<std::size_t>(typeface)];
    }

    std::array<std::unique_ptr<Face>, 2> faces_;  // in the order of Typeface
};

}  // namespace cambrian
