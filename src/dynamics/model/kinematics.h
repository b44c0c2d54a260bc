#pragma once

// Forward kinematics: positions and velocities of all bodies from the coordinates, and the geometry
// of the joints that the articulated body algorithm needs (dynamics/README.md 3).

#include "dynamics/model/motion.h"

namespace cambrian {

struct Kinematics {
    PerBody angle, cosine, sine;     // rad, absolute
    PerBody x, y;                    // m, centre of mass
    PerBody velocity_x, velocity_y;  // m/s
    PerBody spin;                    // rad/s
    // A body's pivot is the joint to its parent, or its centre for roots and prismatic joints.
    // s: velocity of the centre per unit spin of the body about its pivot. z: velocity of the pivot
    // per unit spin of the parent about the parent's pivot. gamma: acceleration of the pivot
    // relative to the parent's pivot at zero coordinate accelerations. axis: prismatic joints,
    // world.
    PerBody s_x, s_y, z_x, z_y, gamma_x, gamma_y;
    PerBody axis_x, axis_y;
    // Coordinate and rate of the joint relative to the rest pose, for motors, limits and sensors.
    PerBody joint_position, joint_rate;  // rad or m, and its rate
    // Of models with stretches only (stretching.h): growth of length and width, 1 for rigid bodies,
    // stretch rate of every body, and y: velocity of the joint per unit stretch rate of the parent.
    bool deforms = false;
    PerBody length_growth, width_growth;
    PerBody stretch_rate;  // 1/s
    PerBody y_x, y_y;      // m
};

// Fills all members.
void compute_kinematics(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);

// Fill some members: angles, spins and joints come first, then velocities or positions.
void compute_joints(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);
// Fills the geometry of the joints (s, z, gamma) from angles and spins; revolute joints only.
void compute_joint_geometry(const PlanarModel& model, Kinematics& kinematics);
void compute_velocities(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);
void compute_places(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);

// Fills the spins of all bodies for any rates of the coordinates.
void spread_spins(const PlanarModel& model, const PerCoordinate& rates, PerBody& spin);
// Fills the spins and the velocities of the centres for any rates at the given positions.
void spread_rates(const PlanarModel& model, const Kinematics& place, const PerCoordinate& rates,
                  PerBody& spin, PerBody& velocity_x, PerBody& velocity_y);

// Returns the largest overrun of a joint past its limits, in rad or m; 0 if there is none.
double limit_overrun(const PlanarModel& model, const Kinematics& kinematics);

double kinetic_energy(const PlanarModel& model, const Kinematics& kinematics);  // J
// Returns twice the kinetic energies of four rigid bodies at these rates.
CAMBRIAN_INLINE Simd4d doubled_energies(const PlanarModel& model, const Simd4d& velocity_x,
                                        const Simd4d& velocity_y, const Simd4d& spin, int first) {
    return load_lanes(model.mass + first) * (velocity_x * velocity_x + velocity_y * velocity_y) +
           load_lanes(model.inertia + first) * (spin * spin);
}

}  // namespace cambrian
