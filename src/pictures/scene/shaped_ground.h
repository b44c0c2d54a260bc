#pragma once

// Ground with a shape, as pictures show it.

#include "render/camera.h"
#include "render/scene_frame.h"
#include "world/environment.h"
#include "world/terrain.h"

namespace cambrian {

// Returns the height of the land around a place, without its bumps, in m.
double land_level(const Environment& environment, double x);

// Returns the height of the ground at a place, in m.
double ground_height(const Environment& environment, double x);

// Gives the frame the surface of the ground in the view. Flat ground has none. It must come before
// everything that stands on the ground.
void use_ground(SceneFrame& frame, const Environment& environment, const Camera& camera,
                const Viewport& viewport);
// The same for ground that is known; null if it is flat.
void use_ground(SceneFrame& frame, const Terrain* ground, const Camera& camera,
                const Viewport& viewport);

}  // namespace cambrian
