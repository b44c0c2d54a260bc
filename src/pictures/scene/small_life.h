#pragma once

// Dust behind slipping feet, bubbles and eddies behind swift tips.

#include "pictures/motion/scuffs.h"
#include "render/scene_frame.h"
#include "world/environment.h"

#include <span>

namespace cambrian {

// Adds what scuffs of a trial stirred up in its world as it is at a time (s): dust on ground,
// eddies in a fluid and, in water, bubbles that rise.
void add_small_life(SceneFrame& frame, std::span<const Scuff> scuffs, double time,
                    const Environment& environment);

}  // namespace cambrian
