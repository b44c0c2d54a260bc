#pragma once

// Where the two points of a pin are, and how they move apart: D = c_a + r_a - c_b - r_b.

#include "dynamics/model/kinematics.h"
#include "math/types.h"

namespace cambrian {

// World offsets of the points from their bodies' centres.
struct PinArms {
    Vec2 a, b;
};

inline Vec2 perp(const Vec2& v) {
    return {-v.y(), v.x()};
}
// A vector of a body's frame in the world's.
Vec2 turned(const Kinematics& kinematics, Eigen::Index body, double x, double y);
Vec2 place(const Kinematics& kinematics, Eigen::Index body);

PinArms pin_arms(const Kinematics& kinematics, const BodyPin& pin);
Vec2 pin_gap(const Kinematics& kinematics, const BodyPin& pin, const PinArms& arms);  // D, m
// The part of D'' that speeds alone make, m/s^2.
Vec2 pin_bias(const Kinematics& kinematics, const BodyPin& pin, const PinArms& arms);

}  // namespace cambrian
