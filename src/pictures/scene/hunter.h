#pragma once

#include "math/types.h"
#include "render/scene_frame.h"

namespace cambrian {

// Draws a light that hunts: a shade with burning eyes, which look at its prey. `time` is that of
// the trial, s.
void add_hunter(SceneFrame& frame, const Vec2& place, const Vec2& prey, double time);

}  // namespace cambrian
