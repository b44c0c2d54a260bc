#pragma once

// The engines compared. Box2D and MuJoCo know no planar articulated creature in a medium, so their
// adapters apply motors and drag once a step, as their users must.

#include "bench/bench_engine.h"
#include "world/scene_settings.h"

#include <string>
#include <vector>

namespace cambrian::bench {

EngineKind planar_engine(std::string id, const SceneSettings& settings);

// What drives Box2D's joints: its own joint motors, told a rate, or torques by our law.
enum class Box2dMotors { kJointMotors, kTorques };
struct Box2dSettings {
    int steps_per_tick = 1;
    int velocity_iterations = 8;  // the manual's suggestion, with 3 for positions
    int position_iterations = 3;
    Box2dMotors motors = Box2dMotors::kJointMotors;
};
EngineKind box2d_engine(std::string id, const Box2dSettings& settings);

enum class MujocoIntegrator { kEuler, kRungeKutta4, kImplicit };
struct MujocoSettings {
    int steps_per_tick = 8;  // 2.1 ms; the default is 2 ms
    MujocoIntegrator integrator = MujocoIntegrator::kEuler;
};
EngineKind mujoco_engine(std::string id, const MujocoSettings& settings);

// Ours first; ratios are to it. The others as their manuals suggest, and as cheap as they go:
// torques instead of Box2D's joint motors, MuJoCo with steps of 5.6 ms.
std::vector<EngineKind> all_engines();

}  // namespace cambrian::bench
