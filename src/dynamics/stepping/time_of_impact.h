#pragma once

// Time of impact: the share of a step at which a new contact is just made (dynamics/README.md 12).
// It is found by bracketing on the step's dense output.

#include "dynamics/constraints/contact_solver.h"
#include "dynamics/stepping/dense_output.h"

namespace cambrian {

// Whether a contact that was not selected for the step penetrates at its end and closes fast, or is
// deeper than the contact band. The solver must have detected the contacts there.
bool has_new_impact(const ContactSolver& contacts);

// Returns the share of the step, in (0, 1], at which no new contact penetrates and one new contact
// is inside the contact band. Motion, kinematics and the solver's near contacts are then those at
// this share.
double find_impact(const PlanarModel& model, const ContactLaw& law, const StepEnds& step,
                   ContactSolver& contacts, Motion& motion, Kinematics& kinematics);

}  // namespace cambrian
