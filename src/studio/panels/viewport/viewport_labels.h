#pragma once

// What is written over the picture of the displayed creature: its name and clock, the ground's
// marks, the names of parts and ghosts, and how far away the wall is.

#include "studio/frame/panel.h"
#include "studio/host/scene_canvas.h"
#include "studio/panels/viewport/space_view.h"

#include <string>

namespace cambrian {

// Whether the viewport offers what can be done with the creature; modes have their own buttons.
bool has_actions(const FrameContext& frame);

// Draws words on a small plate, centred at a place of the world.
void draw_plate(const SceneCanvas& canvas, const Vec2& at, const std::string& words);
// Says how a pen is used, along the bottom of the canvas.
void draw_hint(const SceneCanvas& canvas, const std::string& words);

// The canvas must have the scene; `space` is used where the creature lives in space.
void draw_viewport_labels(const FrameContext& frame, const SceneCanvas& canvas,
                          const SpaceView& space);

}  // namespace cambrian
