#pragma once

// Where a camera looks that keeps to a creature.

#include "creature/phenotype.h"
#include "render/camera.h"

#include <span>

namespace cambrian {

// A rectangle of the world that holds the body, however its parts are turned.
WorldWindow body_window(const Phenotype& phenotype, std::span<const Pose> poses);

// The camera's centre for a creature with that centre of mass. Over ground, the horizon stays where
// it is on screen unless the creature rises out of sight.
Vec2 follow_center(const Vec2& center_of_mass, bool has_ground, const Camera& camera,
                   const Viewport& viewport);

}  // namespace cambrian
