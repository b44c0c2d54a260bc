#pragma once

// Physics in space behind the interface of scenes (world/physics_scene.h): bodies in a medium and
// on the ground, whose parts touch one another if the environment has it.

#include "core/result.h"
#include "world/scene_kind.h"

namespace cambrian {

SceneKind spatial_scene_kind();

}  // namespace cambrian
