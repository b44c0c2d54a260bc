#pragma once

// The audit watches beside the motion: energies (planar/README.md 16), angular momenta of trees
// with their correction (17), and the forces on measured parts.

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

struct TreeSpin {
    double momentum = 0.0;  // kg m^2/s, angular, about the tree's centre of mass
    double inertia = 0.0;   // kg m^2, about that centre
};

// Places and velocities of the kinematics must be those of the motion.
TreeSpin spin_of_tree(const PlanarModel& model, const Motion& motion, const Kinematics& kinematics,
                      int tree);

// Returns the sum of the absolute angular momenta of the tree's bodies about its centre of mass,
// orbital and own, kg m^2/s.
double gross_spin_of_tree(const PlanarModel& model, const Motion& motion,
                          const Kinematics& kinematics, int tree);

// Turns the tree about its centre of mass such that its angular momentum there is that of `before`
// and what was `given`, kg m^2/s. Joints do not move. Returns the kinetic energy of all bodies
// afterwards, J.
double restore_spin(const PlanarModel& model, int tree, double before, double given, Motion& motion,
                    Kinematics& kinematics);

}  // namespace cambrian
