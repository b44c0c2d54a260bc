// The muscle of a joint (creature/README.md 6). The signal is converted to the joint's unit,
// clamped to the joint's limits and smoothed with y <- y + (target - y) (1 - exp(-dt / tau)). The
// joint's motor follows y.

#include "effectors/kinds.h"
#include "math/elementary.h"

#include <algorithm>

namespace cambrian {
namespace {

// Returns the target in the unit of the motor mode.
double motor_target(const EffectorSite& site, double signal, const SceneSettings& settings) {
    switch (site.part.motor_mode) {
        case MotorMode::kVelocity:
            return std::clamp(signal, -settings.motor_speed_limit, settings.motor_speed_limit);
        case MotorMode::kTorque:
            return std::clamp(signal / kPi, -1.0, 1.0);
        case MotorMode::kPosition:
            break;
    }
    const DegreeLimits limits = limits_of(site.part, site.joint.degree);
    return std::clamp(signal, limits.low, limits.high);
}

void drive_joint(const EffectorSite& site, double signal, double share,
                 const SceneSettings& settings, double& memory, PhysicsScene& scene) {
    const double target = motor_target(site, signal, settings);
    memory += (target - memory) * share;
    scene.set_target(site.joint, memory);
}

}  // namespace

double smoothing_share(double dt, double time_constant) {
    return time_constant > 0.0 ? 1.0 - exponential(-dt / time_constant) : 1.0;
}

void add_joint_effector(EffectorRegistry& effectors) {
    effectors.add({.id = "joint", .label = "Joint", .drive = drive_joint});
}

}  // namespace cambrian
