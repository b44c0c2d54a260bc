#pragma once

// A camera that goes round the point it looks at. The horizon stays level.

#include "render/camera.h"
#include "render/space_camera.h"

#include <span>

namespace cambrian {

struct OrbitCamera {
    static constexpr double kNearest = 0.15;  // m
    static constexpr double kFarthest = 400.0;
    static constexpr double kSteepest = to_radians(89.9);

    Vec3 target = Vec3::Zero();       // m; in the middle of the view
    double yaw = to_radians(35.0);    // rad about the vertical; at 0 it looks along -z
    double pitch = to_radians(18.0);  // rad, from above; at most kSteepest either way
    double distance = 4.0;            // m of the target, from kNearest to kFarthest

    SpaceCamera seen(const Viewport& viewport) const;

    // Goes round the target by a drag of so many pixels; the world turns with the pointer.
    void orbit(const Vec2& pixels);
    // Moves the view by a drag of so many pixels.
    void pan(const Vec2& pixels, const Viewport& viewport);
    // Comes closer, or with a factor below 1 goes away, so that the point under the cursor, as far
    // away as the target, stays there.
    void zoom_about(const Vec2& cursor, double factor, const Viewport& viewport);
    // Shows all points so that they fill at most `share` of the view.
    void fit(std::span<const Vec3> points, double share, const Viewport& viewport);
    // Returns the share of the view that points around the target fill, about.
    double share_of(std::span<const Vec3> points, const Viewport& viewport) const;
    // Looks from the side of a direction, the horizon level.
    void look_from(const Vec3& side);
    // Moves the target towards a point, covering 63 % of the way in `lag` seconds, and stays so
    // close that the point is within `most` (m) of the target.
    void approach(const Vec3& point, double elapsed, double lag, double most);

private:
    // Returns the distance of the target from which all points are in that share of the view.
    double distance_for(std::span<const Vec3> points, double share, const Viewport& viewport) const;
};

}  // namespace cambrian
