#pragma once

// The right-hand side of the motion: state and forcing to accelerations and powers.

#include "dynamics/elimination.h"
#include "dynamics/forcing.h"

namespace cambrian {

// One evaluation with all that can be reused of it.
struct Frame {
    Kinematics kinematics;
    Factors factors;
    BodyResponse response;  // accelerations
    PerBody motor_effort;   // N m or N
};

// tick_share: where in the tick, 0 to 1, for the motors' targets.
void evaluate_accelerations(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                            double tick_share, Frame& frame, MotionRate& rate);

// All explicit forces and efforts, with their powers in rate; the frame's kinematics are given and
// its motor efforts are filled.
void compute_loads(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                   double tick_share, Frame& frame, Loads& loads, MotionRate& rate);

// Adds the held contact forces and limit efforts to loads, at the frame's arms.
void add_held_forces(const PlanarModel& model, const Forcing& forcing, const Kinematics& kinematics,
                     Loads& loads);

}  // namespace cambrian
