#pragma once

// Responses to two sets of impulses at once, in the halves of one vector.

#include "dynamics/articulated/articulated_body.h"

namespace cambrian {

// Does what solve_impulse does for each of the two, but fills only the jumps of the coordinates,
// with 0 beyond their count.
void solve_paired_impulses(const PlanarModel& model, const Kinematics& kinematics,
                           const Factors& factors, const Loads (&impulses)[2],
                           PerCoordinate (&jumps)[2]);

// Does the same for impulses that are efforts of joints only.
void solve_paired_efforts(const PlanarModel& model, const Kinematics& kinematics,
                          const Factors& factors, const PerBody (&efforts)[2],
                          PerCoordinate (&jumps)[2]);

}  // namespace cambrian
