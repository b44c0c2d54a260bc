#pragma once

// The view of a world in space: a camera that looks at a point from a distance.

#include "math/angle.h"
#include "math/elementary.h"
#include "math/types.h"

namespace cambrian {

struct SpaceCamera {
    static constexpr double kHalfView = to_radians(17.5);  // half the angle of view, upwards

    Vec3 target = Vec3::Zero();  // m; in the middle of the picture
    Vec3 right = Vec3::UnitX();  // unit vectors of the picture
    Vec3 up = Vec3::UnitY();
    Vec3 back = Vec3::UnitZ();         // towards the camera
    double pixels_per_metre = 100.0;   // at the target
    double width = 1.0, height = 1.0;  // of the picture, pixels

    // A point of the picture, in pixels from its top left, and the distance from the camera, m;
    // points behind the camera have none.
    struct Seen {
        Vec2 place = Vec2::Zero();
        double distance = 0.0;
    };

    // Looks from the side of that yaw about the vertical, from above by the pitch (rad).
    void look_from(double yaw, double pitch) {
        const SineCosine turn = sine_cosine(yaw);
        const SineCosine rise = sine_cosine(pitch);
        right = {turn.cosine, 0.0, -turn.sine};
        back = {rise.cosine * turn.sine, rise.sine, rise.cosine * turn.cosine};
        up = {-rise.sine * turn.sine, rise.cosine, -rise.sine * turn.cosine};
    }

    double distance() const {  // m, of the target
        const SineCosine half = sine_cosine(kHalfView);
        return 0.5 * height * half.cosine / (half.sine * pixels_per_metre);
    }
    Vec3 place() const { return target + distance() * back; }

    Seen look_at(const Vec3& point) const {
        const Vec3 way = point - target;
        const double depth = distance() - way.dot(back);
        const double scale = pixels_per_metre * distance() / (depth > 1e-3 ? depth : 1e-3);
        return {{0.5 * width + scale * way.dot(right), 0.5 * height - scale * way.dot(up)}, depth};
    }
    // Returns the direction in which a point of the picture is seen, not of length 1.
    Vec3 direction(double x, double y) const {
        return ((x - 0.5 * width) * right + (0.5 * height - y) * up) / pixels_per_metre -
               distance() * back;
    }
};

}  // namespace cambrian
