#pragma once

// The wall of a trial as courses of stones without mortar, under a cap.

#include "render/scene_frame.h"
#include "world/fixed_box.h"

namespace cambrian {

// Adds the wall in the frame's light. Its stones are the same in every frame.
void add_stone_wall(SceneFrame& frame, const FixedBox& wall);

}  // namespace cambrian
