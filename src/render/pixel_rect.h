#pragma once

#include "render/camera.h"
#include "render/scene_frame.h"

#include <optional>

namespace cambrian {

// A rectangle of the bound framebuffer; x, y is its lower left corner.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 1;
    int height = 1;

    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

// Returns the pixels of an opaque upright box with sharp corners and no outline, rounded to pixels
// of the target. It is at least one pixel wide and high; outside the target it is empty. Returns
// nothing for any other shape.
std::optional<PixelRect> pixels_of_box(const Shape& shape, const Camera& camera,
                                       const PixelRect& target);

}  // namespace cambrian
