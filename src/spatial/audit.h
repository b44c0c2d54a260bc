#pragma once

// The audit watches beside the motion: the works that were done, the energy that none of them
// explains, and the greatest speeds (planar/README.md 16). The evaluation of a state must be
// current.

#include "spatial/step_control.h"

namespace cambrian::spatial {

// Returns the velocity of a part's centre, m/s.
Vec3 part_velocity(const Model& model, const State& state, int part);

// Raises the audit's maxima to the fastest centre of a part and the fastest spin.
void note_speeds(const Model& model, State& state);

// Updates the works and the residual.
void update_audit(const Model& model, const Medium& medium, State& state);

// Restarts the audit at the present state.
void start_audit(const Model& model, const Medium& medium, State& state);

}  // namespace cambrian::spatial
