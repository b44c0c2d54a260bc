#pragma once

// Motors of the joints: what brains command (physics.md 5, evolution.md 2.6).

#include "dynamics/forcing.h"
#include "dynamics/kinematics.h"

namespace cambrian {

// Effort of every motor at a share of the tick (0 to 1).
void compute_motor_efforts(const PlanarModel& model, const MotorDrive& drive, double tick_share,
                           const Motion& motion, const Kinematics& kinematics, PerBody& effort);

}  // namespace cambrian
