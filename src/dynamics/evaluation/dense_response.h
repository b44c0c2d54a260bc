#pragma once

// What loads and rates do in the dense form (dense_form.h), without the geometry of the joints.

#include "dynamics/evaluation/accelerations.h"

namespace cambrian {

// Accelerations of the centres from those of the coordinates.
void accelerate_dense_centers(const PlanarModel& model, const Kinematics& kinematics,
                              BodyResponse& response);

// Spins of all bodies and velocities of their centres under any rates of the coordinates.
void spread_dense_rates(const PlanarModel& model, const Kinematics& place,
                        const PerCoordinate& rates, PerBody& spin, PerBody& velocity_x,
                        PerBody& velocity_y);

// Both need the frame's inverse. Jumps of the coordinates' speeds under the loads taken as
// impulses, and under efforts of the joints alone. Slots beyond the count are 0.
void solve_dense_impulse(const PlanarModel& model, const Frame& frame, const Loads& impulses,
                         PerCoordinate& jump);
void solve_dense_efforts(const PlanarModel& model, const Frame& frame, const PerBody& efforts,
                         PerCoordinate& jump);

}  // namespace cambrian
