// Critically damped position control with a cap on speed and on effort:
//     tau = clamp(kd (clamp(w/2 (y - phi), +-speed_limit) - phi'), +-max_effort),  kd = 2 I_eff w,
// y the target, phi the joint's coordinate, I_eff its effective inertia. Velocity mode asks for the
// rate y, torque mode for the share y of max_effort.

#include "dynamics/motors.h"

#include <cmath>

namespace cambrian {
namespace {

inline double clamp_size(double value, double size) {
    return std::fmin(std::fmax(value, -size), size);
}

}  // namespace

void compute_motor_efforts(const PlanarModel& model, const MotorDrive& drive, double tick_share,
                           const Motion& motion, const Kinematics& kinematics, PerBody& effort) {
    for (int i = 1; i < model.body_count; ++i) {
        const double target = drive.start[i] + tick_share * (drive.end[i] - drive.start[i]);
        const double cap = model.max_effort[i];
        if (model.motor_mode[i] == MotorMode::kTorque) {
            effort[i] = clamp_size(target, 1.0) * cap;
            continue;
        }
        const double wanted =
            model.motor_mode[i] == MotorMode::kVelocity
                ? target
                : 0.5 * drive.frequency * (target - joint_coordinate(model, motion, kinematics, i));
        const double rate = clamp_size(wanted, drive.speed_limit * model.rate_scale[i]);
        const double gain = 2.0 * model.effective_inertia[i] * drive.frequency;
        effort[i] = clamp_size(gain * (rate - joint_rate(model, motion, kinematics, i)), cap);
    }
}

}  // namespace cambrian
