#pragma once

// The articulated body algorithm for trees with stretches (dynamics/README.md 20): a deformable
// body eliminates its stretch before its joint is looked at, and what is left is a rigid body to
// the joint. The factors of a stretch's slot are w, w_3 (to the body's spin) and 1/d.

#include "dynamics/articulated/articulated_body.h"

namespace cambrian {

// Does what solve_accelerations does, with the damping that the factors hold.
void solve_stretched_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                                   const Loads& loads, Factors& factors, BodyResponse& response);

// Does what solve_impulse does.
void solve_stretched_impulse(const PlanarModel& model, const Kinematics& kinematics,
                             const Factors& factors, const Loads& impulses, BodyResponse& response);

}  // namespace cambrian
