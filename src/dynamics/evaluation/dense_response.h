#pragma once

// Responses to loads and rates in the dense form (dense_form.h), without geometry of the joints.

#include "dynamics/evaluation/accelerations.h"

namespace cambrian {

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
