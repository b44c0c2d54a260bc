#pragma once

// Motors of the joints: what brains command (physics.md 5, evolution.md 2.6).

#include "dynamics/model/forcing.h"
#include "dynamics/model/kinematics.h"

namespace cambrian {

struct MotorPower {
    double net = 0.0;    // W
    double gross = 0.0;  // W; sum of every joint's |power|
};

// Effort of every motor at a share of the tick (0 to 1), and the powers.
MotorPower compute_motor_efforts(const PlanarModel& model, const MotorDrive& drive,
                                 double tick_share, const Kinematics& kinematics, PerBody& effort);

// A stage some time after a step's start, at which joint rates are those at the start plus that
// time times the stage's own accelerations.
struct ImplicitStage {
    double time = 0.0;          // s
    const PerBody& start_rate;  // of every joint, at the step's start
};

// The same law for an implicit stage: the effort is `effort` less `damping` times the joint's
// acceleration. The kinematics are a prediction of the stage's; who is predicted to give all it
// can has no damping.
void compute_implicit_efforts(const PlanarModel& model, const MotorDrive& drive, double tick_share,
                              const ImplicitStage& stage, const Kinematics& kinematics,
                              PerBody& effort, PerBody& damping);

// The law of a joint's motor (MotorLaw) from its mode, cap and effective inertia; rate_scale is the
// share of the speed limit that holds for it.
void set_motor_law(PlanarModel& model, int body, double rate_scale);

}  // namespace cambrian
