#pragma once

// The visible part of the world. Screen coordinates are pixels from the top left of the viewport, y
// down.

#include "math/types.h"

namespace cambrian {

struct Viewport {
    double width = 1.0;  // pixels
    double height = 1.0;
};

struct WorldWindow {
    Vec2 low = Vec2::Zero();  // m
    Vec2 high = Vec2::Zero();
};

struct Camera {
    static constexpr double kMinScale = 4.0;
    static constexpr double kMaxScale = 4000.0;

    Vec2 center = Vec2::Zero();       // m; world point in the middle of the viewport
    double pixels_per_metre = 100.0;  // from kMinScale to kMaxScale

    double pixel() const { return 1.0 / pixels_per_metre; }  // m; size of a pixel
    Vec2 to_screen(const Vec2& world, const Viewport& viewport) const;
    Vec2 to_world(const Vec2& screen, const Viewport& viewport) const;
    WorldWindow window(const Viewport& viewport) const;

    // Zooms so that the world point under the cursor stays there. A factor over 1 magnifies.
    void zoom_about(const Vec2& cursor, double factor, const Viewport& viewport);
    // Moves the view by a drag of so many pixels.
    void pan(const Vec2& pixels);
    // Shows a rectangle of the world so that it fills at most `share` of the viewport.
    void fit(const WorldWindow& target, double share, const Viewport& viewport);
    // Moves as little as is needed to show a rectangle of the world with a margin around it, which
    // is a share of the viewport. If it does not fit, its middle is shown.
    void keep_in_view(const WorldWindow& target, double margin, const Viewport& viewport);
    // Moves towards a point; covers 63 % of the distance in `lag` seconds.
    void approach(const Vec2& target, double elapsed, double lag);
};

}  // namespace cambrian
