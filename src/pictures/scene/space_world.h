#pragma once

// The surroundings of creatures in space: the medium, its light, the floor and what hangs in it.

#include "pictures/canvas/palette.h"
#include "pictures/scene/worlds.h"
#include "render/space_frame.h"
#include "world/environment.h"

namespace cambrian {

// How a world in space is seen. `time` is that of the trial, in s.
struct SpaceLook {
    Daytime daytime = Daytime::kNoon;
    const Palette* plain = nullptr;  // draws a plain background of these colours instead of scenery
    bool grid = false;               // draws a grid of metres on the floor
    double time = 0.0;
};

// Gives a frame, whose camera is set, the surroundings of an environment.
void use_space(SpaceFrame& frame, const Environment& environment, const SpaceLook& look);
// Adds specks that hang in a medium without ground, so that motion through it is seen.
void add_hanging_specks(SpaceFrame& frame, const Color& color);

}  // namespace cambrian
