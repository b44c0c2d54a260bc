#pragma once

// Body plan to articulated model: welding of rigid joints, depth-first order, masses, effective
// joint inertia and the list of boxes that may collide (physics.md 3).

#include "core/result.h"
#include "dynamics/model/planar_model.h"

namespace cambrian {

// density in kg/m^2, above 0. Fails, naming the part, on more than 32 bodies or 64 parts, boxes
// thinner than 2 cm, non-finite numbers, broken parent order, limits in the wrong order, a body
// lighter than 1e-4 of the whole, or closing pins that are over 64, name no part, lie within one
// body or are over 1e-6 m apart in the rest pose.
Result<PlanarModel> build_planar_model(const BodyPlan& plan, double density);

}  // namespace cambrian
