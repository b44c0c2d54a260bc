#pragma once

// Draws a preserve: its water, walls and food, and all creatures in the hues of their lineages.

#include "pictures/canvas/palette.h"
#include "render/camera.h"
#include "render/scene_frame.h"
#include "studio/preserve/preserve_view.h"

#include <cstdint>

namespace cambrian {

void add_world(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const Viewport& viewport, const PreserveView& preserve);

// Returns the number of the creature at a point of the world, or within `reach` (m) of one's centre
// of mass; 0 if there is none.
std::uint64_t resident_at(const PreservePicture& picture, const Vec2& point, double reach);

// Returns a circle's radius around a creature that contains its parts, in m.
double reach_of(const ResidentPicture& resident);

}  // namespace cambrian
