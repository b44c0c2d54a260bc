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

// The pixels of a shape that is an opaque upright box with sharp corners and no outline, at least
// one pixel wide and high: those of the target nearest to it, or a rectangle without any if it is
// outside. Nothing for any other shape.
std::optional<PixelRect> pixels_of_box(const Shape& shape, const Camera& camera,
                                       const PixelRect& target);

}  // namespace cambrian
