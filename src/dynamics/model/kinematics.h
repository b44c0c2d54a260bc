#pragma once

// Where every body is and how it moves, from the coordinates; and the geometry of the joints that
// the elimination needs (physics.md 4.2, pass 1).

#include "dynamics/model/motion.h"

namespace cambrian {

struct Kinematics {
    PerBody angle, cosine, sine;     // rad, absolute
    PerBody x, y;                    // m, centre of mass
    PerBody velocity_x, velocity_y;  // m/s
    PerBody spin;                    // rad/s
    // A body's pivot is the joint to its parent, or its centre on roots and behind linear joints.
    // How the centre moves with the body's spin about the pivot (s), how the pivot moves with the
    // parent's spin about the parent's (z), and its acceleration at zero coordinate accelerations,
    // seen from there (gamma). On linear joints also the world axis.
    PerBody s_x, s_y, z_x, z_y, gamma_x, gamma_y;
    PerBody axis_x, axis_y;
    // Coordinate and rate of the joint as motors, limits and sensors see them: relative to rest.
    PerBody joint_position, joint_rate;  // rad or m, and a second
};

// All of it.
void compute_kinematics(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);

// Its parts: angles, spins and joints, which the others need; velocities; places.
void compute_joints(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);
// The geometry of the joints (s, z, gamma) from angles and spins; rotary joints only.
void compute_joint_geometry(const PlanarModel& model, Kinematics& kinematics);
void compute_velocities(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);
void compute_places(const PlanarModel& model, const Motion& motion, Kinematics& kinematics);

// Spins that any rates of the coordinates mean.
void spread_spins(const PlanarModel& model, const PerCoordinate& rates, PerBody& spin);
// The same, and velocities of the centres at a place.
void spread_rates(const PlanarModel& model, const Kinematics& place, const PerCoordinate& rates,
                  PerBody& spin, PerBody& velocity_x, PerBody& velocity_y);

// How far the worst joint is past its limits, rad or m; 0 if none is.
double limit_overrun(const PlanarModel& model, const Kinematics& kinematics);

double kinetic_energy(const PlanarModel& model, const Kinematics& kinematics);  // J

}  // namespace cambrian
