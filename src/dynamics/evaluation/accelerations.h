#pragma once

// The right-hand side of the motion: state and forcing to accelerations and powers.

#include "dynamics/articulated/elimination.h"
#include "dynamics/forces/motors.h"
#include "dynamics/model/forcing.h"

namespace cambrian {

// One evaluation with all that can be reused of it.
struct Frame {
    Kinematics kinematics;
    Loads loads;
    Factors factors;
    BodyResponse response;  // accelerations, loops closed
    PerBody motor_effort;   // N m or N
    PerBody motor_damping;  // where motors are implicit: effort lost per joint acceleration
    // In place of the factors, where the frame was evaluated in dense form with implicit motors:
    // inverse of the mass matrix with their damping, by columns of DenseForm.
    double inverse[kMaxDenseBodies * kMaxDenseBodies];
    // Whether the accelerations of the bodies' centres are there, the geometry of the joints, the
    // factors; else find_centers and complete_frame bring them.
    bool has_centers;
    bool has_joint_geometry;
    bool is_factored;
    bool is_inverted;  // whether the inverse is there
};

// What of the kinematics is to be left in the frame: what this forcing needs for the accelerations,
// or all of it. The frame may lack its factors either way.
enum class FrameDetail : std::uint8_t { kAccelerations, kEverything };

struct EvaluationPoint {
    double tick_share = 0.0;  // where in the tick, 0 to 1, for the motors' targets
    FrameDetail detail = FrameDetail::kEverything;
    const ImplicitStage* implicit = nullptr;  // for the motors' damping; null: explicit
};

void evaluate_accelerations(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                            const EvaluationPoint& point, Frame& frame, MotionRate& rate);

// Bring what a frame evaluated with everything may lack: the accelerations of the centres, and all.
void find_centers(const PlanarModel& model, Frame& frame);
void complete_frame(const PlanarModel& model, Frame& frame);

// All explicit forces and efforts into the frame, with their powers into rate; the frame's
// kinematics are given. Where motors are implicit their powers are left 0.
void compute_loads(const PlanarModel& model, const Forcing& forcing, const EvaluationPoint& point,
                   Frame& frame, MotionRate& rate);

// Adds contact forces and limit efforts to loads, at the kinematics' arms.
void add_held_forces(const PlanarModel& model, const HeldForces& held, const Kinematics& kinematics,
                     Loads& loads);

}  // namespace cambrian
