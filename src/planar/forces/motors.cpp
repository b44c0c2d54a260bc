// Critically damped position control with a limit on speed and on effort (planar/README.md 6):
//     tau = clamp(kd (clamp(w/2 (y - phi), +-speed_limit) - phi'), +-max_effort),  kd = 2 I_eff w,
// with the target y, the joint coordinate phi, the frequency w and the effective inertia I_eff. In
// velocity mode y is the wanted rate, in torque mode the share of max_effort. All three modes are
// one formula,
//     wanted = clamp(tracking w (y - phi) + direct y, +-(rate_scale speed_limit + rate_floor))
//     tau = clamp((stiffness w + strength) (wanted - damping phi'), +-max_effort),
// with coefficients that depend on the mode, so four joints are computed at once.

#include "planar/forces/motors.h"

#include "core/assert.h"

namespace cambrian {

void set_motor_law(PlanarModel& model, int body, double rate_scale) {
    MotorLaw& law = model.motor;
    const MotorMode mode = model.motor_mode[body];
    const bool is_position = mode == MotorMode::kPosition;
    const bool is_torque = mode == MotorMode::kTorque;
    CAMBRIAN_TICK_ASSERT(!(model.effective_inertia[body] <= 0.0), "an effort moves its joint");
    CAMBRIAN_TICK_ASSERT(model.max_effort[body] >= 0.0, "a motor has some strength");
    law.tracking[body] = is_position ? 0.5 : 0.0;
    law.direct[body] = is_position ? 0.0 : 1.0;
    law.rate_scale[body] = is_torque ? 0.0 : rate_scale;
    law.rate_floor[body] = is_torque ? 1.0 : 0.0;
    law.stiffness[body] = is_torque ? 0.0 : 2.0 * model.effective_inertia[body];
    law.strength[body] = is_torque ? model.max_effort[body] : 0.0;
    law.damping[body] = is_torque ? 0.0 : 1.0;
}

MotorPower compute_motor_efforts(const PlanarModel& model, const MotorDrive& drive,
                                 double tick_share, const Kinematics& kinematics, PerBody& effort) {
    CAMBRIAN_TICK_ASSERT(tick_share >= 0.0 && tick_share <= 1.0 + 1e-9, "a moment of the tick");
    Simd4d net = {};
    Simd4d gross = {};
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d rate = load_lanes(kinematics.joint_rate + i);
        const Simd4d given = motor_efforts(model, drive, tick_share,
                                           load_lanes(kinematics.joint_position + i), rate, i);
        store_lanes(effort + i, given);
        const Simd4d power = given * rate;
        net += power;
        gross += magnitude(power);
    }
    return {sum_of(net), sum_of(gross)};
}

void compute_implicit_efforts(const PlanarModel& model, const MotorDrive& drive, double tick_share,
                              const ImplicitStage& stage, const Kinematics& kinematics,
                              PerBody& effort, PerBody& damping) {
    for (int i = 0; i < model.body_count; i += kLanes) {
        const ImplicitEfforts motors = implicit_efforts(model, drive, tick_share, stage,
                                                        load_lanes(kinematics.joint_position + i),
                                                        load_lanes(kinematics.joint_rate + i), i);
        store_lanes(effort + i, motors.effort);
        store_lanes(damping + i, motors.damping);
        CAMBRIAN_TICK_ASSERT(!(-largest_of(-motors.damping) < 0.0), "a motor damps");
    }
}

}  // namespace cambrian
