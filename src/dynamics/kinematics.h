#pragma once

// Where every body is and how it moves, from the coordinates; and the geometry of the joints that
// the elimination needs (physics.md 4.2, pass 1).

#include "dynamics/motion.h"

namespace cambrian {

struct Kinematics {
    PerBody angle, cosine, sine;     // rad, absolute
    PerBody x, y;                    // m, centre of mass
    PerBody velocity_x, velocity_y;  // m/s
    PerBody spin;                    // rad/s
    // Of the joint to the parent: how the child's centre moves with the parent's spin (z), with
    // the joint's own coordinate (s; for linear joints the world axis), and its acceleration at
    // zero coordinate accelerations (gamma).
    PerBody z_x, z_y, s_x, s_y, gamma_x, gamma_y;
};

void compute_kinematics(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);

// Coordinate and rate of a joint as motors, limits and sensors see them: relative to rest.
inline double joint_coordinate(const PlanarModel& model, const Motion& motion,
                               const Kinematics& kinematics, int body) {
    if (model.joint[body] == JointType::kLinear) return motion.position[coordinate_of(body)];
    return kinematics.angle[body] - kinematics.angle[model.parent[body]] - model.rest_angle[body];
}
inline double joint_rate(const PlanarModel& model, const Motion& motion,
                         const Kinematics& kinematics, int body) {
    if (model.joint[body] == JointType::kLinear) return motion.speed[coordinate_of(body)];
    return kinematics.spin[body] - kinematics.spin[model.parent[body]];
}

// J; potential energy is 0 where the centre of mass is at the origin.
double kinetic_energy(const PlanarModel& model, const Kinematics& kinematics);

}  // namespace cambrian
