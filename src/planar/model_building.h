#pragma once

// Builds the model from a body plan: it welds rigid joints, orders bodies depth first and computes
// masses, effective inertias of joints and pairs of boxes that may collide (planar/README.md 2).

#include "core/result.h"
#include "planar/model/planar_model.h"

namespace cambrian {

// `density` is in kg/m^2 and positive. Fails, naming the part, for more than 32 bodies or 64 parts,
// boxes thinner than 2 cm, numbers that are not finite, children before parents, limits in the
// wrong order, and bodies lighter than 1e-4 of the total mass.
Result<PlanarModel> build_planar_model(const BodyPlan& plan, double density);

}  // namespace cambrian
