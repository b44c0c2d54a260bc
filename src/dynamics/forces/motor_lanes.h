#pragma once

// The motor law of motors.cpp for four joints at once, from `first` on.

#include "dynamics/forces/motors.h"

namespace cambrian {

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
