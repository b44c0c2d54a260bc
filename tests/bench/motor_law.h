#pragma once

// The law of our joint motors, for engines whose motors are to follow it.

#include "world/body_plan.h"
#include "world/scene_settings.h"

#include <algorithm>

namespace cambrian::bench {

// Returns the wanted rate, in rad/s, of a joint in position or velocity mode.
inline double wanted_rate(MotorMode mode, double target, double coordinate) {
    const SceneSettings motors;
    const double rate = mode == MotorMode::kVelocity
                            ? target
                            : 0.5 * motors.motor_frequency * (target - coordinate);
    return std::clamp(rate, -motors.motor_speed_limit, motors.motor_speed_limit);
}

// Returns the torque in N m; `inertia` (kg m^2) is that against which an effort at this joint acts.
inline double motor_torque(const PlannedPart& part, double inertia, double wanted, double rate) {
    const double gain = 2.0 * inertia * SceneSettings{}.motor_frequency;
    return std::clamp(gain * (wanted - rate), -part.max_effort, part.max_effort);
}

}  // namespace cambrian::bench
