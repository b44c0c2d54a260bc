#pragma once

// The right-hand side of the motion: state and forcing to accelerations and powers.

#include "dynamics/elimination.h"
#include "dynamics/forcing.h"

namespace cambrian {

// One evaluation with all that can be reused of it.
struct Frame {
    Kinematics kinematics;
    Loads loads;
    Factors factors;
    BodyResponse response;  // accelerations, loops closed
    PerBody motor_effort;   // N m or N
    // Whether factors, the geometry of the joints and the accelerations of the bodies' centres are
    // there; else complete_frame brings them.
    bool is_factored;
};

// What of the kinematics is to be left in the frame: what this forcing needs for the accelerations,
// or all of it. The frame may lack its factors either way.
enum class FrameDetail : std::uint8_t { kAccelerations, kEverything };

struct EvaluationPoint {
    double tick_share = 0.0;  // where in the tick, 0 to 1, for the motors' targets
    FrameDetail detail = FrameDetail::kEverything;
};

void evaluate_accelerations(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                            const EvaluationPoint& point, Frame& frame, MotionRate& rate);

// What a frame evaluated with everything may lack: its factors.
void complete_frame(const PlanarModel& model, Frame& frame);

// All explicit forces and efforts into the frame, with their powers into rate; the frame's
// kinematics are given.
void compute_loads(const PlanarModel& model, const Forcing& forcing, double tick_share,
                   Frame& frame, MotionRate& rate);

// Adds the held contact forces and limit efforts to loads, at the frame's arms.
void add_held_forces(const PlanarModel& model, const Forcing& forcing, const Kinematics& kinematics,
                     Loads& loads);

}  // namespace cambrian
