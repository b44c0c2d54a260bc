#pragma once

// The energy books of a scene (physics.md 9).

#include "dynamics/stepping/step_control.h"

namespace cambrian {

// J; kinetic and potential, 0 height at the origin.
double mechanical_energy(const PlanarModel& model, const Medium& medium, const Motion& motion,
                         const Kinematics& kinematics);

// Fastest part centre and spin at the moment, for the audit's maxima.
void note_speeds(const PlanarModel& model, const Kinematics& kinematics, SceneAudit& audit);

// Deepest penetration and widest limit overrun.
void note_depths(const ContactSet& contacts, double limit_overrun, SceneAudit& audit);

// Brings the works and the residual up to the moment, which must be current.
void close_books(const PlanarModel& model, const Medium& medium, SceneMoment& moment);

// Starts the books anew from the moment, which must be current.
void open_books(const PlanarModel& model, const Medium& medium, SceneMoment& moment);

}  // namespace cambrian
