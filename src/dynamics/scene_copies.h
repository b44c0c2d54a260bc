#pragma once

// The layer is compiled for several sets of processor instructions; a scene is made of one of
// these copies and stays in it. All of them compute the same bits (lanes.h).

#include "core/result.h"
#include "world/body_plan.h"
#include "world/environment.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <memory>
#include <string>
#include <vector>

// The copy that is being compiled.
#ifndef CAMBRIAN_SCENE_COPY
#define CAMBRIAN_SCENE_COPY baseline
#endif

namespace cambrian {

using SceneMaker = Result<std::unique_ptr<PhysicsScene>> (*)(const BodyPlan&, const Environment&,
                                                             const SceneSettings&);

// As make of SceneKind, in each copy.
namespace baseline {
Result<std::unique_ptr<PhysicsScene>> make_planar_scene(const BodyPlan& plan,
                                                        const Environment& environment,
                                                        const SceneSettings& settings);
}
namespace avx2 {
Result<std::unique_ptr<PhysicsScene>> make_planar_scene(const BodyPlan& plan,
                                                        const Environment& environment,
                                                        const SceneSettings& settings);
}

struct SceneCopy {
    std::string instructions;  // "baseline" or "avx2"
    SceneMaker make;
};

// The copies this processor can run, the fastest first; the last one is the baseline.
std::vector<SceneCopy> scene_copies();

}  // namespace cambrian
