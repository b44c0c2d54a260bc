#pragma once

#include "world/scene_kind.h"

namespace cambrian {

// Planar articulated-body physics: motion in x and y and about z.
SceneKind planar_scene_kind();

}  // namespace cambrian
