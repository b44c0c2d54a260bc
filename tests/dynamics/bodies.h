#pragma once

// Scenes with small bodies for the tests of physics.

#include "dynamics/planar_scene.h"
#include "support/body_plans.h"

#include <memory>

namespace cambrian {

std::unique_ptr<PhysicsScene> make_scene(const BodyPlan& plan, const Environment& environment,
                                         const SceneSettings& settings = {});

}  // namespace cambrian
