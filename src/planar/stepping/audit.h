#pragma once

// The audit watches beside the motion: energies (planar/README.md 16), touches and impacts, and the
// forces on measured parts.

#include "planar/contact/contact.h"
#include "planar/model/kinematics.h"
#include "planar/stepping/step_control.h"

namespace cambrian {

// Kinetic and potential energy, J; the potential is 0 at the origin.
double mechanical_energy(const PlanarModel& model, const Medium& medium, const Motion& motion,
                         double kinetic);
// Returns that of the present state, whose cache must be current.
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

// Notes the speeds at the start of a motion, of which the kinematics are given.
void note_speeds(const PlanarModel& model, const Kinematics& kinematics, PartForces& forces);

void begin_forces(const PlanarModel& model, PartForces& forces);

// Adds the normal impulse (N s) of a contact to the parts that touch.
void add_load(const PlanarModel& model, const Contact& contact, double impulse, PartForces& forces);

// The kinematics must be those of the end of the tick, which lasted `duration` (s).
void end_forces(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                double duration, PartForces& forces);

void note_touch(const Contact& contact, SimulationState& state);

// Notes an impact on another creature or the ground; the impulse is in N s, and `work` in J is that
// of the impact.
void note_impact(const PlanarModel& model, const Kinematics& kinematics, const Contact& contact,
                 double impulse, double work, SimulationState& state);

}  // namespace cambrian
