// Critically damped position control with a cap on speed and on effort:
//     tau = clamp(kd (clamp(w/2 (y - phi), +-speed_limit) - phi'), +-max_effort),  kd = 2 I_eff w,
// y the target, phi the joint's coordinate, w the drive's frequency, I_eff the joint's effective
// inertia. Velocity mode asks for the rate y, torque mode for the share y of max_effort. All three
// are one formula,
//     wanted = clamp(tracking w (y - phi) + direct y, +-(rate_scale speed_limit + rate_floor))
//     tau = clamp((stiffness w + strength) (wanted - damping phi'), +-max_effort),
// with numbers that depend on the mode, so that four joints go at once.

#include "dynamics/motors.h"

namespace cambrian {

void set_motor_law(PlanarModel& model, int body, double rate_scale) {
    MotorLaw& law = model.motor;
    const MotorMode mode = model.motor_mode[body];
    const bool is_position = mode == MotorMode::kPosition;
    const bool is_torque = mode == MotorMode::kTorque;
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
    const MotorLaw& law = model.motor;
    Lanes net = {};
    Lanes gross = {};
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Lanes start = load_lanes(drive.start + i);
        const Lanes target = start + tick_share * (load_lanes(drive.end + i) - start);
        const Lanes rate = load_lanes(kinematics.joint_rate + i);
        const Lanes tracking = drive.frequency * load_lanes(law.tracking + i);
        const Lanes asked = tracking * (target - load_lanes(kinematics.joint_position + i)) +
                            load_lanes(law.direct + i) * target;
        const Lanes fastest =
            drive.speed_limit * load_lanes(law.rate_scale + i) + load_lanes(law.rate_floor + i);
        const Lanes wanted = clamp_size(asked, fastest);
        const Lanes gain =
            drive.frequency * load_lanes(law.stiffness + i) + load_lanes(law.strength + i);
        const Lanes given = clamp_size(gain * (wanted - load_lanes(law.damping + i) * rate),
                                       load_lanes(model.max_effort + i));
        store_lanes(effort + i, given);
        const Lanes power = given * rate;
        net += power;
        gross += magnitude(power);
    }
    return {sum_of(net), sum_of(gross)};
}

}  // namespace cambrian
