#pragma once

// Geometry of loop-closure joints: the deviation D = c_a + r_a - c_b - r_b of their points.

#include "dynamics/model/kinematics.h"
#include "math/types.h"

namespace cambrian {

// World offsets of the points from their bodies' centres.
struct LoopArms {
    Vec2 a, b;
};

inline Vec2 perp(const Vec2& v) {
    return {-v.y(), v.x()};
}
// Rotates a vector from a body's frame to the world.
Vec2 turned(const Kinematics& kinematics, Eigen::Index body, double x, double y);
Vec2 place(const Kinematics& kinematics, Eigen::Index body);

LoopArms loop_arms(const Kinematics& kinematics, const LoopJoint& joint);
Vec2 loop_gap(const Kinematics& kinematics, const LoopJoint& joint, const LoopArms& arms);  // D, m
// The velocity terms of D'', m/s^2.
Vec2 loop_bias(const Kinematics& kinematics, const LoopJoint& joint, const LoopArms& arms);

}  // namespace cambrian
