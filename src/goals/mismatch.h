#pragma once

// Environments in which a goal makes no sense; see GoalKind::mismatch.

#include "world/environment.h"

#include <string>

namespace cambrian {

// For what pushes off the ground: there is one, and something holds the creature to it.
std::string needs_ground(const Environment& environment);

// For what pushes off the medium: it is thick enough, and neither ground nor fall gets in the way.
std::string needs_water(const Environment& environment);

}  // namespace cambrian
