#pragma once

// Motions as lists of numbers, which scenes hand over (world/physics_scene.h), and their digest.

#include "core/hash.h"
#include "spatial/motion.h"
#include "world/physics_scene.h"

#include <optional>

namespace cambrian::spatial {

// The root's attitude is given as a quaternion between the joints and the centre of mass, those of
// balls follow at the end. The coordinates of balls among the joints are 0.
SceneMotion scene_motion_of(const Model& model, const Motion& motion, const double* targets);

// Returns a motion without works, or nothing if the numbers are not those of a motion of this
// model.
std::optional<Motion> motion_of(const Model& model, const SceneMotion& numbers);

void add_to_digest(const Model& model, const Motion& motion, Hash64& digest);

}  // namespace cambrian::spatial
