#pragma once

// The state of articulated bodies and its rate of change (dynamics/README.md 1). The coordinates
// are (s_0 ... s_{n-1}, Cx and Cy of every tree). s_i is the ABSOLUTE angle of a root or of a body
// behind a revolute joint, the length of a prismatic joint, the stretch of a deformable body in its
// own slot, or always 0 at a rigid joint; C is the centre of mass of a tree.
// Joints cannot come apart in these coordinates. Slots beyond the count, up to a multiple of the
// vector width, are 0.

#include "dynamics/model/planar_model.h"

namespace cambrian {

// Works that are integrated along with the motion, J, and one impulse, N m s: what drag and pulls
// give to the angular momentum about the centre of mass, in models of one tree.
enum Work : int { kMotorWork, kGrossMotorWork, kDragWork, kPullWork, kSpinGiven, kWorkCount };

struct Motion {
    PerCoordinate position;   // m or rad
    PerCoordinate speed;      // m/s or rad/s
    double work[kWorkCount];  // J, but for kSpinGiven
};

struct MotionRate {
    PerCoordinate acceleration;  // m/s^2 or rad/s^2
    double power[kWorkCount];    // W, but for kSpinGiven: N m
};

inline int coordinate_count(const PlanarModel& model) {
    return model.body_count + 2 * model.tree_count;
}
// The count rounded up to a multiple of the vector width.
inline int coordinate_slots(const PlanarModel& model) {
    return round_up_to_lanes(coordinate_count(model));
}
// Index of Cx of a tree; Cy follows. The coordinate of a body is its own number.
inline int center_of(const PlanarModel& model, int tree) {
    return model.body_count + 2 * tree;
}

inline void copy_motion(const PlanarModel& model, const Motion& from, Motion& to) {
    const int slots = coordinate_slots(model);
    for (int c = 0; c < slots; c += kLanes) {
        store_lanes(to.position + c, load_lanes(from.position + c));
        store_lanes(to.speed + c, load_lanes(from.speed + c));
    }
    std::memcpy(to.work, from.work, sizeof(to.work));
}
inline void copy_rate(const PlanarModel& model, const MotionRate& from, MotionRate& to) {
    const int slots = coordinate_slots(model);
    for (int c = 0; c < slots; c += kLanes)
        store_lanes(to.acceleration + c, load_lanes(from.acceleration + c));
    std::memcpy(to.power, from.power, sizeof(to.power));
}

// Returns the plan's rest pose without motion.
Motion rest_motion(const PlanarModel& model);

}  // namespace cambrian
