#pragma once

#include "dynamics/kinematics.h"

namespace cambrian {

// Where the boxes are, in the world.
struct PartPlaces {
    PerPart x, y;            // m, centres
    PerPart axis_x, axis_y;  // unit, along the length
};

void place_parts(const PlanarModel& model, const Kinematics& kinematics, PartPlaces& places);

}  // namespace cambrian
