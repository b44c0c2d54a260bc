#pragma once

#include "dynamics/model/kinematics.h"

namespace cambrian {

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
