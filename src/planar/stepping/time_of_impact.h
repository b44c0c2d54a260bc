#pragma once

// Time of impact: the share of a step at which a new contact is just made (planar/README.md 12).
// It is found by bracketing on the step's dense output.

#include "planar/constraints/contact_solver.h"
#include "planar/model/planar_model.h"

namespace cambrian {

// The motion inside an accepted step, from the states and rates at its ends (planar/README.md
// 14): quintic Hermite polynomials for positions, cubic ones for speeds, and for works the
// quadratic power with the right values at both ends and the right integral.

struct StepEnds {
    const Motion& start;
    const MotionRate& start_rate;
    const Motion& end;
    const MotionRate& end_rate;
    double length = 0.0;  // s
};

// `slots` is the number of coordinates; `share` is in [0, 1] of the step.
void interpolate_motion(int slots, const StepEnds& step, double share, Motion& motion);

// Whether a contact that was not selected for the step penetrates at its end and closes fast, or is
// deeper than the contact band. The solver must have detected the contacts there.
bool has_new_impact(const ContactSolver& contacts);

// The first new contact of boxes within a step, if any.
struct Crossing {
    double share = 1.0;  // of the step, at which a new contact penetrates; 1 if none does
    double depth = 0.0;  // m; deepest penetration up to there, of contacts that were selected
};

// Looks at the motion at the ends of equal parts of a step, but for its own ends. Afterwards the
// solver's near contacts are those of the last look. It is rare, so it is not inlined.
[[gnu::noinline]] Crossing find_crossing(const PlanarModel& model, const ContactLaw& law,
                                         const StepEnds& step, int parts, ContactSolver& contacts);

// Returns the share of the step, in (0, `until`], at which no new contact penetrates and one new
// contact is inside the contact band. Motion, kinematics and the solver's near contacts are then
// those at this share. Before, the near contacts are those at `until`.
double find_impact(const PlanarModel& model, const ContactLaw& law, const StepEnds& step,
                   double until, ContactSolver& contacts, Motion& motion, Kinematics& kinematics);

}  // namespace cambrian
