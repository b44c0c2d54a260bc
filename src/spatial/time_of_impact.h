#pragma once

// Time of impact: the share of a step at which a new contact is just made (planar/README.md 12).
// It is found by bracketing on the step's dense output.

#include "spatial/rows.h"

namespace cambrian::spatial {

// The motion inside an accepted step, from the states and rates at its ends: cubic Hermite
// polynomials. Those of positions and of works are exact under constant accelerations.
struct StepEnds {
    const Motion& start;
    const MotionRate& start_rate;
    const Motion& end;
    const MotionRate& end_rate;
    double length = 0.0;  // s
    bool has_ground = false;
};

// `share` is in [0, 1] of the step.
void interpolate_motion(const Model& model, const StepEnds& step, double share, Motion& motion);

// Whether a contact that was not selected for the step closes fast and penetrates, or is deeper
// than the contact band.
bool has_new_impact(const ContactSet& near, const Rows& selected);

// Returns the share of the step at which no new contact penetrates and one is inside the contact
// band. Before, the near contacts are those at the step's end; afterwards motion, kinematics and
// near contacts are those at this share.
double find_impact(const Model& model, const StepEnds& step, const Rows& selected, ContactSet& near,
                   Motion& motion, Kinematics& kinematics);

}  // namespace cambrian::spatial
