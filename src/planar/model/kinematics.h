#pragma once

// Forward kinematics: positions and velocities of all bodies from the coordinates, and the geometry
// of the joints that the articulated body algorithm needs (planar/README.md 3).

#include "planar/model/planar_model.h"

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

// Positions and directions of all boxes in the world.
struct PartPlaces {
    PerPart x, y;            // m, centres
    PerPart axis_x, axis_y;  // unit, along the length
    // Present half extents of all boxes, m: the model's, or those here if some are stretched.
    const double* half_length;
    const double* half_width;
    PerPart stretched_length, stretched_width;
};

// Points at the present half extents. The model may have moved in memory since the boxes were
// placed.
inline void use_sizes(const PlanarModel& model, PartPlaces& places) {
    const bool deforms = model.stretch_count > 0;
    places.half_length = deforms ? places.stretched_length : model.half_length;
    places.half_width = deforms ? places.stretched_width : model.half_width;
}

void place_parts(const PlanarModel& model, const Kinematics& kinematics, PartPlaces& places);

// Four boxes, from `first` on.
struct PartLanes {
    Simd4d cosine, sine;  // of their bodies
    Simd4dVector offset;  // m, in the bodies' frames
    Simd4dVector arm;     // m, the same in the world
};

CAMBRIAN_INLINE PartLanes part_lanes(const PlanarModel& model, const Kinematics& k, int first) {
    const int* bodies = model.part_body + first;
    const Simd4d cosine = gather(k.cosine, bodies);
    const Simd4d sine = gather(k.sine, bodies);
    const Simd4dVector offset = {load_lanes(model.part_x + first),
                                 load_lanes(model.part_y + first)};
    return {cosine, sine, offset, turned(offset, cosine, sine)};
}

// Returns unit vectors along the boxes' lengths.
CAMBRIAN_INLINE Simd4dVector part_axes(const PlanarModel& model, const PartLanes& parts,
                                       int first) {
    return turned({load_lanes(model.part_cosine + first), load_lanes(model.part_sine + first)},
                  parts.cosine, parts.sine);
}

// Returns the velocities of points at these arms from bodies' centres, in m/s.
CAMBRIAN_INLINE Simd4dVector velocities_at(const Simd4dVector& arm, const Simd4dVector& velocity,
                                           const Simd4d& spin) {
    return {velocity.x - spin * arm.y, velocity.y + spin * arm.x};
}

// Returns velocities of the boxes' centres, in m/s.
CAMBRIAN_INLINE Simd4dVector part_velocities(const PlanarModel& model, const Kinematics& k,
                                             const PartLanes& parts, int first) {
    const int* bodies = model.part_body + first;
    return velocities_at(parts.arm, {gather(k.velocity_x, bodies), gather(k.velocity_y, bodies)},
                         gather(k.spin, bodies));
}

}  // namespace cambrian
