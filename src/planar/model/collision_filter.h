#pragma once

// The pairs of boxes that may collide (planar/README.md 2).

#include "planar/model/planar_model.h"

namespace cambrian {

// Returns all pairs of boxes except three kinds: boxes of one body, boxes of bodies that share a
// joint, and boxes that overlap or are nearer than 1 cm in the rest pose of the plan.
std::vector<PartPair> find_colliding_pairs(const PlanarModel& model, const BodyPlan& plan);

}  // namespace cambrian
