#pragma once

// Motors of the joints (planar/README.md 6).

#include "planar/model/kinematics.h"
#include "planar/model/planar_model.h"

namespace cambrian {

struct MotorPower {
    double net = 0.0;    // W, net power
    double gross = 0.0;  // W, sum of every joint's |power|
};

// Computes the effort of every motor at a share of the tick (0 to 1), and returns the powers.
MotorPower compute_motor_efforts(const PlanarModel& model, const MotorDrive& drive,
                                 double tick_share, const Kinematics& kinematics, PerBody& effort);

// A stage at some time after a step's start. Its joint rates are those at the start plus this time
// multiplied by the stage's own accelerations.
struct ImplicitStage {
    double time = 0.0;          // s
    const PerBody& start_rate;  // of every joint, at the step's start
};

// Computes the efforts of an implicit stage: `effort` minus `damping` times the joint's
// acceleration. The kinematics are a prediction of the stage's. A motor that is predicted to reach
// its maximal effort has no damping.
void compute_implicit_efforts(const PlanarModel& model, const MotorDrive& drive, double tick_share,
                              const ImplicitStage& stage, const Kinematics& kinematics,
                              PerBody& effort, PerBody& damping);

// Sets the law of a joint's motor from its mode, maximal effort and effective inertia. rate_scale
// multiplies the speed limit of the settings.
void set_motor_law(PlanarModel& model, int body, double rate_scale);

// The motor law of motors.cpp for four joints at once, from `first` on.

// The target rates of four motors, and their efforts per difference in rate.
struct WantedRates {
    Simd4d rate, gain;
};

CAMBRIAN_INLINE WantedRates wanted_rates(const MotorLaw& law, const MotorDrive& drive,
                                         double tick_share, const Simd4d& position, int first) {
    const Simd4d start = load_lanes(drive.start + first);
    const Simd4d target = start + tick_share * (load_lanes(drive.end + first) - start);
    const Simd4d tracking = drive.frequency * load_lanes(law.tracking + first);
    const Simd4d asked = tracking * (target - position) + load_lanes(law.direct + first) * target;
    const Simd4d fastest =
        drive.speed_limit * load_lanes(law.rate_scale + first) + load_lanes(law.rate_floor + first);
    return {clamp_size(asked, fastest),
            drive.frequency * load_lanes(law.stiffness + first) + load_lanes(law.strength + first)};
}

// Returns efforts at these coordinates and rates of the joints, in N m or N.
CAMBRIAN_INLINE Simd4d motor_efforts(const PlanarModel& model, const MotorDrive& drive,
                                     double tick_share, const Simd4d& position, const Simd4d& rate,
                                     int first) {
    const WantedRates wanted = wanted_rates(model.motor, drive, tick_share, position, first);
    return clamp_size(wanted.gain * (wanted.rate - load_lanes(model.motor.damping + first) * rate),
                      load_lanes(model.max_effort + first));
}

// Efforts and damping in an implicit stage (compute_implicit_efforts).
struct ImplicitEfforts {
    Simd4d effort, damping;
};

CAMBRIAN_INLINE ImplicitEfforts implicit_efforts(const PlanarModel& model, const MotorDrive& drive,
                                                 double tick_share, const ImplicitStage& stage,
                                                 const Simd4d& position, const Simd4d& rate,
                                                 int first) {
    const WantedRates wanted = wanted_rates(model.motor, drive, tick_share, position, first);
    const Simd4d share = load_lanes(model.motor.damping + first);
    const Simd4d most = load_lanes(model.max_effort + first);
    const Simd4d predicted = wanted.gain * (wanted.rate - share * rate);
    const Simd4d at_start =
        wanted.gain * (wanted.rate - share * load_lanes(stage.start_rate + first));
    const auto spare = magnitude(predicted) < most;
    return {spare ? at_start : clamp_size(predicted, most),
            spare ? stage.time * wanted.gain * share : Simd4d{}};
}

}  // namespace cambrian
