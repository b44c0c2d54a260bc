#pragma once

// Motors of the joints: what brains command (physics.md 5, evolution.md 2.6).

#include "dynamics/forcing.h"
#include "dynamics/kinematics.h"

namespace cambrian {

struct MotorPower {
    double net = 0.0;    // W
    double gross = 0.0;  // W; sum of every joint's |power|
};

// Effort of every motor at a share of the tick (0 to 1), and the powers.
MotorPower compute_motor_efforts(const PlanarModel& model, const MotorDrive& drive,
                                 double tick_share, const Kinematics& kinematics, PerBody& effort);

// The law of a joint's motor (MotorLaw) from its mode, cap and effective inertia; rate_scale is the
// share of the speed limit that holds for it.
void set_motor_law(PlanarModel& model, int body, double rate_scale);

}  // namespace cambrian
