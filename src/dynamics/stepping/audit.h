#pragma once

// The energy audit of a scene (dynamics/README.md 16).

#include "dynamics/stepping/step_control.h"

namespace cambrian {

// Kinetic and potential energy, J; the potential is 0 at the origin.
double mechanical_energy(const PlanarModel& model, const Medium& medium, const Motion& motion,
                         double kinetic);
// Of the present state, whose cache must be current.
double mechanical_energy(const PlanarModel& model, const Medium& medium, SimulationState& state);

// Raises the audit's maxima to the fastest centre of a part and the fastest spin.
void note_speeds(const PlanarModel& model, const Kinematics& kinematics, SceneAudit& audit);

// Raises the audit's maxima to the deepest penetration and this overrun of a limit.
void note_depths(const ContactSet& contacts, double limit_overrun, SceneAudit& audit);

// Adds the works of every creature's motors during a step of `time` (s) between these caches, by
// the trapezoidal rule.
void note_member_works(const PlanarModel& model, const EvaluationCache& begin,
                       const EvaluationCache& end, double time, SimulationState& state);

// Updates the works and the residual. The cache must be current.
void update_audit(const PlanarModel& model, const Medium& medium, SimulationState& state);

// Restarts the audit at the present state. The cache must be current.
void start_audit(const PlanarModel& model, const Medium& medium, SimulationState& state);

}  // namespace cambrian
