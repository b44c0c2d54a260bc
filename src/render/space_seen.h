#pragma once

// What a frame of space is drawn by: the camera with its matrix, and parts of the picture and of
// the floor.

#include "render/opengl/gl.h"
#include "render/space_painter.h"

#include <array>

namespace cambrian {

inline constexpr double kFloorReach = 120.0;  // distances of the target

// The rectangle of the floor that shadows fall on.
struct SpacePainter::Footprint {
    Vec2 low = Vec2::Constant(1e9);
    Vec2 high = Vec2::Constant(-1e9);

    bool empty() const { return low.x() >= high.x(); }
    Vec2 size() const { return high - low; }
    void add(const Vec2& middle, double reach) {
        low = low.cwiseMin(middle - Vec2::Constant(reach));
        high = high.cwiseMax(middle + Vec2::Constant(reach));
    }
};

// A part of the picture, and where the picture's lower left corner is in the framebuffer.
struct SpacePainter::Place {
    int x = 0;
    int y = 0;
    PixelRect part;

    void use() const { glScissor(x + part.x, y + part.y, part.width, part.height); }
};

// The camera with places relative to its target.
struct SpacePainter::Seen {
    SpaceCamera camera;
    Vec3 eye;
    Vec3 sun;
    std::array<float, 16> view;  // column by column
    int width = 1;               // pixels
    int height = 1;
    Footprint foot = {};

    Seen(const SpaceFrame& frame, const PixelRect& target);
    double pixel() const { return 1.0 / (camera.pixels_per_metre * camera.distance()); }
    // Returns below which row of the picture there is nothing but floor.
    int rows_of_floor(const SpaceFloor* floor, const Vec3& target) const;
};

}  // namespace cambrian
