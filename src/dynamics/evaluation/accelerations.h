#pragma once

// The right-hand side of the equations of motion: accelerations and powers from state and forcing.

#include "dynamics/articulated/articulated_body.h"
#include "dynamics/forces/motors.h"
#include "dynamics/model/forcing.h"

namespace cambrian {

// The results of one evaluation that can be reused.
struct EvaluationCache {
    Kinematics kinematics;
    Loads loads;
    Factors factors;
    BodyResponse response;  // accelerations
    PerBody motor_effort;   // N m or N
    PerBody motor_damping;  // of implicit motors: effort lost per joint acceleration
    // The inverse of the mass matrix with the damping of the motors, by columns of DenseForm. It
    // replaces the factors after an evaluation in dense form with implicit motors.
    double inverse[kMaxDenseBodies * kMaxDenseBodies];
    // Whether accelerations of the bodies' centres, geometry of the joints and factors are valid.
    // find_centers and complete_cache compute them.
    bool has_centers;
    bool has_joint_geometry;
    bool is_factored;
    bool is_inverted;  // whether the inverse is valid
};

// The kinematics that an evaluation computes: those that its accelerations need, or all. The
// factors may be missing in both cases. An implicit stage keeps the accelerations in both.
enum class EvaluationDetail : std::uint8_t { kAccelerations, kEverything };

struct EvaluationPoint {
    double tick_share = 0.0;  // time in the tick, in [0, 1], for the motors' targets
    EvaluationDetail detail = EvaluationDetail::kEverything;
    const ImplicitStage* implicit = nullptr;  // for the motors' damping; null: explicit
};

void evaluate_accelerations(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                            const EvaluationPoint& point, EvaluationCache& cache, MotionRate& rate);

// Complete a cache that was evaluated with kEverything: the accelerations of the centres, or all.
void find_centers(const PlanarModel& model, EvaluationCache& cache);
void complete_cache(const PlanarModel& model, EvaluationCache& cache);

// Computes all external forces and efforts from the cache's kinematics, and their powers. Powers of
// implicit motors are 0.
void compute_loads(const PlanarModel& model, const Forcing& forcing, const EvaluationPoint& point,
                   EvaluationCache& cache, MotionRate& rate);

// Adds contact forces and limit efforts to the loads, with arms at the given positions.
void add_held_forces(const PlanarModel& model, const HeldForces& held, const Kinematics& kinematics,
                     Loads& loads);

}  // namespace cambrian
