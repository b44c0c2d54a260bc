#pragma once

// Checks of environments for GoalKind::mismatch.

#include "world/environment.h"

#include <string>

namespace cambrian {

// For goals that need a ground to push against and gravity that holds the creature there.
std::string needs_ground(const Environment& environment);

// For contests, which also need ground that does not slope to one side.
std::string needs_level_ground(const Environment& environment);

// For goals that need ground which is not flat.
std::string needs_shaped_ground(const Environment& environment);

// For goals that count the obstacles of a course.
std::string needs_course(const Environment& environment);

// For goals that need a wall on one side, and ground to walk away on.
std::string needs_wall(const Environment& environment);

// For goals that need a medium to push against, without ground and without falling.
std::string needs_water(const Environment& environment);

// For goals that need gravity, a medium that carries the creature, and no ground.
std::string needs_air(const Environment& environment);

// For goals that need a jumping or a hunting light, and ground or a medium to push against.
std::string needs_jumping_light(const Environment& environment);
std::string needs_hunting_light(const Environment& environment);

}  // namespace cambrian
