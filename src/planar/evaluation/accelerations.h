#pragma once

// The right-hand side of the equations of motion: accelerations and powers from state and forcing.

#include "planar/articulated/articulated_body.h"
#include "planar/forces/motors.h"
#include "planar/model/planar_model.h"

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

// The right-hand side of the equations of motion in dense form (dense_form.h).

// Whether the dense form applies: no contact forces and no pull.
inline bool is_dense(const PlanarModel& model, const Forcing& forcing) {
    return model.dense.blocks > 0 && forcing.held == nullptr && forcing.pulls.empty();
}

// Does what evaluate_accelerations does, with an incomplete cache: it has no geometry of the
// joints, no factors, and a response of coordinates and spins only (find_centers, complete_cache).
// With implicit motors it has the inverse mass matrix.
void evaluate_dense(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                    const EvaluationPoint& point, EvaluationCache& cache, MotionRate& rate);

// Responses to loads and rates in the dense form (dense_form.h), without geometry of the joints.

// Computes the accelerations of the centres from those of the coordinates.
void accelerate_dense_centers(const PlanarModel& model, const Kinematics& kinematics,
                              BodyResponse& response);

// Computes spins and velocities of the centres for any rates of the coordinates.
void spread_dense_rates(const PlanarModel& model, const Kinematics& place,
                        const PerCoordinate& rates, PerBody& spin, PerBody& velocity_x,
                        PerBody& velocity_y);

// Compute the jumps of the speeds under loads as impulses, and under impulses of the joints alone.
// Both need the cache's inverse. Slots beyond the count are 0.
void solve_dense_impulse(const PlanarModel& model, const EvaluationCache& cache,
                         const Loads& impulses, PerCoordinate& jump);
void solve_dense_efforts(const PlanarModel& model, const EvaluationCache& cache,
                         const PerBody& efforts, PerCoordinate& jump);

}  // namespace cambrian
