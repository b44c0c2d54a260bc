#pragma once

// The attitude of a ball joint: that of a body in the joint frame of its parent, x along the body
// at rest. It is a turn about x, the twist, and then a swing about an axis across x. Angles are in
// the order of the joint's degrees of freedom: bend about z, bend about y, twist. Both bends are
// the components of the swing's rotation vector.

#include "spatial/algebra.h"

namespace cambrian::spatial {

struct BallAngles {
    double bend_z = 0.0, bend_y = 0.0, twist = 0.0;  // rad

    double swing() const { return std::sqrt(bend_z * bend_z + bend_y * bend_y); }
};

// Degrees of freedom of a ball as a vector.
inline Vec3 ball_vector(const double* degrees) {
    return {degrees[2], degrees[1], degrees[0]};
}

// Swings are below pi, twists in (-pi, pi].
BallAngles ball_angles(const Rotation& attitude);
Rotation ball_attitude(const BallAngles& angles);

// Returns the rates of the angles, rad/s, under a spin in the axes of the joint frame. They are 0
// where a swing reaches pi.
BallAngles ball_rates(const Rotation& attitude, const Vec3& spin);

// Returns the rotation vector from one attitude to another, in the axes of the first. Between
// attitudes whose swings and twists are below pi it turns through such, also where that takes more
// than pi.
Vec3 turn_between(const Rotation& from, const Rotation& to);

// How the swing and the twist change with the spin, at one moment.
struct BallDirections {
    // Their rates are these times the spin. What is not swung may swing in any direction.
    Vec3 swing = Vec3::UnitZ();
    Vec3 twist = Vec3::UnitX();
    // rad/s^2; what the angles accelerate without the spin's acceleration
    double swing_bias = 0.0, twist_bias = 0.0;
};

// `frame` is the joint frame and `body` that of the body, both in the axes of the spin.
BallDirections ball_directions(const Turn& frame, const Turn& body, const Vec3& spin);

}  // namespace cambrian::spatial
