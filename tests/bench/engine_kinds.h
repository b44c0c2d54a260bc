#pragma once

// The engines that are compared. Box2D and MuJoCo have no planar articulated creatures in a medium,
// so their adapters apply motors and drag once per step, as their users would.

#include "bench/bench_engine.h"
#include "world/scene_settings.h"

#include <string>
#include <vector>

namespace cambrian::bench {

EngineKind planar_engine(std::string id, const SceneSettings& settings);

// How Box2D's joints are driven: by its own joint motors or by torques from our motor law.
enum class Box2dMotors { kJointMotors, kTorques };
struct Box2dSettings {
    int steps_per_tick = 1;
    int velocity_iterations = 8;  // suggested by the manual, with 3 for positions
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

// Returns all engines; ours is first, since ratios are relative to it. Others are run as their
// manuals suggest and in their cheapest form: torques instead of Box2D's joint motors, MuJoCo with
// steps of 5.6 ms.
std::vector<EngineKind> all_engines();

}  // namespace cambrian::bench
