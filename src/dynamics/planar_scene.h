#pragma once

#include "world/scene_kind.h"

namespace cambrian {

// Planar articulated-body physics: motion in x and y and about z. A plan with loop joints needs
// the integrator "least-squares", and is refused by all others.
SceneKind planar_scene_kind();

}  // namespace cambrian
