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
    // Coordinate and rate of the joint as motors, limits and sensors see them: relative to rest.
    PerBody joint_position, joint_rate;  // rad or m, and a second
};

// All of it.
void compute_kinematics(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);

// Its parts: angles, spins and joints, which the others need; velocities; places.
void compute_joints(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);
void compute_velocities(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);
void compute_places(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);

double kinetic_energy(const PlanarModel& model, const Kinematics& kinematics);  // J

}  // namespace cambrian
