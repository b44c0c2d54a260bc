#pragma once

// Motors of the joints (dynamics/README.md 6).

#include "dynamics/model/forcing.h"
#include "dynamics/model/kinematics.h"

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

}  // namespace cambrian
