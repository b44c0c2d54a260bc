#pragma once

// The sounds of impacts (simulator/README.md 6).

#include "world/emissions.h"
#include "world/physics_scene.h"

#include <span>
#include <vector>

namespace cambrian {

inline constexpr int kGroundBand = 0;    // band of impacts on the ground
inline constexpr int kCreatureBand = 1;  // band of impacts of creatures on each other

// Appends the sounds of a tick's impacts; faint ones make none.
void add_noise(std::span<const SceneImpact> impacts, std::vector<Sound>& sounds);

}  // namespace cambrian
