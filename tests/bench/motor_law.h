#pragma once

// What our motors ask of their joints, for engines whose motors are to do the same (physics.md 5).

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

// N m; inertia (kg m^2) is what a lone effort at this joint feels.
inline double motor_torque(const PlannedPart& part, double inertia, double wanted, double rate) {
    const double gain = 2.0 * inertia * SceneSettings{}.motor_frequency;
    return std::clamp(gain * (wanted - rate), -part.max_effort, part.max_effort);
}

}  // namespace cambrian::bench
