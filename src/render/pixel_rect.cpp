#include "render/pixel_rect.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

bool is_sharp_box(const Shape& shape) {
    return shape.angle == 0.0 && shape.radius == 0.0 && shape.outline_width == 0.0 &&
           shape.blur == 0.0 && shape.fill.a >= 1.0F;
}

struct Span {
    int from = 0;
    int length = 0;
};

// Returns the pixels of 0 .. count-1 that a box covers; `center` is relative to their middle.
Span pixels_along(double center, double half_extent, int count) {
    const double length = std::fmax(1.0, std::round(2.0 * half_extent));
    const double from = std::round(0.5 * count + center - 0.5 * length);
    const double first = std::clamp(from, 0.0, 1.0 * count);
    const double last = std::clamp(from + length, 0.0, 1.0 * count);
    return {static_cast<int>(first), static_cast<int>(last - first)};
}

}  // namespace

std::optional<PixelRect> pixels_of_box(const Shape& shape, const Camera& camera,
                                       const PixelRect& target) {
    if (!is_sharp_box(shape)) return std::nullopt;
    const Vec2 center = (shape.center - camera.center) * camera.pixels_per_metre;
    const Vec2 half = shape.half_extents * camera.pixels_per_metre;
    const Span across = pixels_along(center.x(), half.x(), target.width);
    const Span up = pixels_along(center.y(), half.y(), target.height);
    return PixelRect{target.x + across.from, target.y + up.from, across.length, up.length};
}

}  // namespace cambrian
