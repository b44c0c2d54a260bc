#pragma once

#include "dynamics/model/kinematics.h"

namespace cambrian {

// Positions and directions of all boxes in the world.
struct PartPlaces {
    PerPart x, y;            // m, centres
    PerPart axis_x, axis_y;  // unit, along the length
};

void place_parts(const PlanarModel& model, const Kinematics& kinematics, PartPlaces& places);

// The components of four vectors.
struct LanePair {
    Lanes x, y;
};

// Four boxes at once, from `first` on.
struct PartLanes {
    Lanes cosine, sine;  // of their bodies
    LanePair offset;     // m, in the bodies' frames
    LanePair arm;        // m, the same in the world
};

CAMBRIAN_INLINE PartLanes part_lanes(const PlanarModel& model, const Kinematics& k, int first) {
    const int* bodies = model.part_body + first;
    const Lanes cosine = gather(k.cosine, bodies);
    const Lanes sine = gather(k.sine, bodies);
    const Lanes x = load_lanes(model.part_x + first);
    const Lanes y = load_lanes(model.part_y + first);
    return {cosine, sine, {x, y}, {cosine * x - sine * y, sine * x + cosine * y}};
}

// Unit, along the boxes' lengths.
CAMBRIAN_INLINE LanePair part_axes(const PlanarModel& model, const PartLanes& parts, int first) {
    const Lanes cosine = load_lanes(model.part_cosine + first);
    const Lanes sine = load_lanes(model.part_sine + first);
    return {parts.cosine * cosine - parts.sine * sine, parts.sine * cosine + parts.cosine * sine};
}

// m/s, of the boxes' centres.
CAMBRIAN_INLINE LanePair part_velocities(const PlanarModel& model, const Kinematics& k,
                                         const PartLanes& parts, int first) {
    const int* bodies = model.part_body + first;
    const Lanes spin = gather(k.spin, bodies);
    return {gather(k.velocity_x, bodies) - spin * parts.arm.y,
            gather(k.velocity_y, bodies) + spin * parts.arm.x};
}

}  // namespace cambrian
