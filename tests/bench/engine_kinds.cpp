#include "bench/engine_kinds.h"

namespace cambrian::bench {

std::vector<EngineKind> all_engines() {
    constexpr int fewest_mujoco_steps = 3;  // per tick; its users seldom use steps over 5 ms
    return {planar_engine("cambrian", {}), box2d_engine("box2d", {}),
            box2d_engine("box2d-torques", {.motors = Box2dMotors::kTorques}),
            mujoco_engine("mujoco", {}),
            mujoco_engine("mujoco-coarse", {.steps_per_tick = fewest_mujoco_steps})};
}

}  // namespace cambrian::bench
