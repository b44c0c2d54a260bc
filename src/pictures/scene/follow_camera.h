#pragma once

// The position of a camera that follows a creature.

#include "creature/phenotype.h"
#include "render/camera.h"
#include "world/environment.h"

#include <span>

namespace cambrian {

// Returns a rectangle of the world that contains the body for any rotation of its parts.
WorldWindow body_window(const Phenotype& phenotype, std::span<const Pose> poses);

// Returns the camera's centre for a creature with that centre of mass. Over ground, the horizon
// keeps its place on the screen unless the creature would rise out of sight or sink into a pit.
Vec2 follow_center(const Vec2& center_of_mass, const Environment& environment, const Camera& camera,
                   const Viewport& viewport);

}  // namespace cambrian
