#pragma once

// What stands, grows and floats in a world beside the creatures: the sun, grass, weed, specks, a
// lamp, and marks on the ground.

#include "pictures/scene/worlds.h"
#include "render/camera.h"

namespace cambrian {

// Gives the frame the backdrop and the light of a world, and adds what grows and floats behind
// creatures. `time` is that of the trial, in s; blades sway and bubbles rise with it.
void add_scenery(SceneFrame& frame, const DrawnWorld& world, const Camera& camera,
                 const Viewport& viewport, double time);
// Adds the glow of a lamp and lets it shine on skins; half of its light is left at `reach` (m).
void add_lamp(SceneFrame& frame, const Camera& camera, const Viewport& viewport, const Vec2& place,
              double reach);
// Adds marks along the ground, so many metres apart.
void add_ground_marks(SceneFrame& frame, const DrawnWorld& world, const Camera& camera,
                      const Viewport& viewport, double spacing);
// Adds blades before the creatures' feet.
void add_foreground(SceneFrame& frame, const DrawnWorld& world, const Camera& camera,
                    const Viewport& viewport, double time);

}  // namespace cambrian
