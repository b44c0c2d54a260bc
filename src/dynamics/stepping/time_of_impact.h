#pragma once

// Where within a step a new contact is just made (physics.md 8; the step is bisected on its dense
// output).

#include "dynamics/constraints/contact_solver.h"
#include "dynamics/stepping/dense_output.h"

namespace cambrian {

// Whether something that was not chosen for the step penetrates at its end, closing fast. The
// solver must have collected there.
bool has_new_impact(const ContactSolver& contacts);

// Share of the step, in (0, 1], at which nothing new penetrates and one new contact is inside the
// touching band. motion and kinematics are left there, and the solver's collection.
double find_impact(const PlanarModel& model, const ContactLaw& law, const StepEnds& step,
                   ContactSolver& contacts, Motion& motion, Kinematics& kinematics);

}  // namespace cambrian
