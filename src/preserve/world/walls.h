#pragma once

// The soft walls of a preserve (preserve/README.md 2).

#include "creature/phenotype.h"
#include "evolution/settings/world_area.h"
#include "preserve/world/rectangle.h"
#include "world/physics_scene.h"

#include <span>

namespace cambrian {

inline constexpr int kPullsOfWalls = 1;  // on one body in a tick, at most

// Pushes the part with the corner that is farthest beyond a wall back during the next tick. `parts`
// are the parts' rectangles of the moment.
void push_back(PhysicsScene& scene, const Phenotype& phenotype, std::span<const Rectangle> parts,
               const WorldArea& area, double density);

}  // namespace cambrian
