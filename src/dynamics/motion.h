#pragma once

// The state of an articulated body and its rate of change, as the integrators see them
// (physics.md 2): coordinates (Cx, Cy, s_0 ... s_{n-1}) with C the centre of mass of the whole
// body, s_0 the root's angle, s_i the ABSOLUTE angle of a body behind a rotary joint or the
// length of a linear one. Joints cannot come apart in these coordinates.

#include "dynamics/planar_model.h"

namespace cambrian {

// Works integrated along with the motion, J.
enum Work : int { kMotorWork, kGrossMotorWork, kDragWork, kPullWork, kWorkCount };

struct Motion {
    PerCoordinate position = {};   // m or rad
    PerCoordinate speed = {};      // m/s or rad/s
    double work[kWorkCount] = {};  // J
};

struct MotionRate {
    PerCoordinate acceleration = {};  // m/s^2 or rad/s^2
    double power[kWorkCount] = {};    // W
};

inline int coordinate_count(const PlanarModel& model) {
    return model.body_count + 2;
}
// Index of the coordinate of a body's joint, or of the root's angle.
inline int coordinate_of(int body) {
    return body + 2;
}

// At rest in the plan's rest pose.
Motion rest_motion(const PlanarModel& model);

}  // namespace cambrian
