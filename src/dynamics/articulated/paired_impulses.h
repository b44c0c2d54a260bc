#pragma once

// Two impulses on the same bodies at once, side by side in lanes.

#include "dynamics/articulated/elimination.h"

namespace cambrian {

// As solve_impulse for each of the two, but only what the coordinates do.
void solve_paired_impulses(const PlanarModel& model, const Kinematics& kinematics,
                           const Factors& factors, const Loads (&impulses)[2],
                           PerCoordinate (&jumps)[2]);

}  // namespace cambrian
