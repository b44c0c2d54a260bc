#pragma once

// The rate a motor asks its joint for, so that every engine's motors want the same (physics.md 5).

#include "world/body_plan.h"
#include "world/scene_settings.h"

#include <algorithm>

namespace cambrian::bench {

// rad/s, of a joint in position or velocity mode.
inline double wanted_rate(MotorMode mode, double target, double coordinate) {
    const SceneSettings motors;
    const double rate = mode == MotorMode::kVelocity
                            ? target
                            : 0.5 * motors.motor_frequency * (target - coordinate);
    return std::clamp(rate, -motors.motor_speed_limit, motors.motor_speed_limit);
}

}  // namespace cambrian::bench
