#pragma once

// Which boxes may ever touch each other (physics.md 3.4, evolution.md 2.4).

#include "dynamics/model/planar_model.h"

namespace cambrian {

// All pairs of boxes but those of one body, of bodies that share a joint, and those that overlap
// or are nearer than 1 cm in the rest pose of the plan the model was built from.
std::vector<PartPair> find_colliding_pairs(const PlanarModel& model, const BodyPlan& plan);

}  // namespace cambrian
