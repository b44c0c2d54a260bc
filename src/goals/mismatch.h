#pragma once

// Checks of environments for GoalKind::mismatch.

#include "world/environment.h"

#include <string>

namespace cambrian {

// For goals that need a ground to push against and gravity that holds the creature there.
std::string needs_ground(const Environment& environment);

// For goals that need a medium to push against, without ground and without falling.
std::string needs_water(const Environment& environment);

// For what flies: something pulls it down, the medium carries it, and there is no ground in its
// way.
std::string needs_air(const Environment& environment);

// For what follows a light: it jumps, and something to push off from, ground or medium.
std::string needs_jumping_light(const Environment& environment);

}  // namespace cambrian
