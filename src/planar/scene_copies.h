#pragma once

// The layer is compiled for several sets of processor instructions. A scene is created from one of
// these copies and stays with it. All copies compute the same bits (planar/README.md 19).

#include "core/result.h"
#include "world/body_plan.h"
#include "world/environment.h"
#include "world/joined_scenes.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <memory>
#include <span>
#include <vector>

// The namespace of the copy that is being compiled.
#ifndef CAMBRIAN_SCENE_COPY
#define CAMBRIAN_SCENE_COPY baseline
#endif

// Keeps a function that is called from outside: gcc compiles a copy as a program without other
// callers.
#if defined(__GNUC__) && !defined(__clang__)
#define CAMBRIAN_CALLED_FROM_OUTSIDE [[gnu::externally_visible]]
#else
#define CAMBRIAN_CALLED_FROM_OUTSIDE
#endif

namespace cambrian {

using SceneMaker = Result<std::unique_ptr<PhysicsScene>> (*)(const BodyPlan&, const Environment&,
                                                             const SceneSettings&);

using SceneJoiner = std::unique_ptr<JoinedScenes> (*)(std::span<PhysicsScene* const>);

// Each copy's functions for `make` and `join` of SceneKind.
namespace baseline {
Result<std::unique_ptr<PhysicsScene>> make_planar_scene(const BodyPlan& plan,
                                                        const Environment& environment,
                                                        const SceneSettings& settings);
std::unique_ptr<JoinedScenes> join_planar_scenes(std::span<PhysicsScene* const> scenes);
}  // namespace baseline
namespace avx2 {
CAMBRIAN_CALLED_FROM_OUTSIDE
Result<std::unique_ptr<PhysicsScene>> make_planar_scene(const BodyPlan& plan,
                                                        const Environment& environment,
                                                        const SceneSettings& settings);
CAMBRIAN_CALLED_FROM_OUTSIDE
std::unique_ptr<JoinedScenes> join_planar_scenes(std::span<PhysicsScene* const> scenes);
}  // namespace avx2

struct SceneCopy {
    SceneMaker make;
    SceneJoiner join;  // of scenes of this copy
};

// The copies this processor can run, the fastest first; the last one is the baseline.
std::vector<SceneCopy> scene_copies();

}  // namespace cambrian
