#pragma once

// The engines compared. Box2D and MuJoCo know no planar articulated creature in a medium, so their
// adapters apply motors' wanted rates and drag once a step, as their users must.

#include "bench/bench_engine.h"
#include "world/scene_settings.h"

#include <string>
#include <vector>

namespace cambrian::bench {

EngineKind planar_engine(std::string id, const SceneSettings& settings);

struct Box2dSettings {
    int steps_per_tick = 1;
    int velocity_iterations = 8;  // the manual's suggestion, with 3 for positions
    int position_iterations = 3;
};
EngineKind box2d_engine(std::string id, const Box2dSettings& settings);

enum class MujocoIntegrator { kEuler, kRungeKutta4, kImplicit };
struct MujocoSettings {
    int steps_per_tick = 8;  // 2.1 ms; the default is 2 ms
    MujocoIntegrator integrator = MujocoIntegrator::kEuler;
};
EngineKind mujoco_engine(std::string id, const MujocoSettings& settings);

// Ours first; ratios are to it.
std::vector<EngineKind> all_engines();

}  // namespace cambrian::bench
