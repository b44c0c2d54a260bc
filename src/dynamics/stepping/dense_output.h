#pragma once

// The motion inside an accepted step, from the states and rates at its ends (dynamics/README.md
// 14): quintic Hermite polynomials for positions, cubic ones for speeds, and for works the
// quadratic power with the right values at both ends and the right integral.

#include "dynamics/model/motion.h"

namespace cambrian {

struct StepEnds {
    const Motion& start;
    const MotionRate& start_rate;
    const Motion& end;
    const MotionRate& end_rate;
    double length = 0.0;  // s
};

// `slots` is the number of coordinates; `share` is in [0, 1] of the step.
void interpolate_motion(int slots, const StepEnds& step, double share, Motion& motion);

}  // namespace cambrian
