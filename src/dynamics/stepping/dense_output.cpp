#include "dynamics/stepping/dense_output.h"

#include "core/assert.h"

namespace cambrian {

void interpolate_motion(int slots, const StepEnds& step, double share, Motion& motion) {
    CAMBRIAN_TICK_ASSERT(share >= 0.0 && share <= 1.0, "a place within the step");
    CAMBRIAN_TICK_ASSERT(step.length > 0.0, "a step takes time");
    const double h = step.length;
    const double t = share;
    const double t2 = t * t;
    const double t3 = t2 * t;
    const double blend = t3 * (10.0 + t * (-15.0 + 6.0 * t));
    const double start_speed = h * t * (1.0 + t2 * (-6.0 + t * (8.0 - 3.0 * t)));
    const double end_speed = h * t3 * (-4.0 + t * (7.0 - 3.0 * t));
    const double start_turn = 0.5 * h * h * t2 * (1.0 + t * (-3.0 + t * (3.0 - t)));
    const double end_turn = 0.5 * h * h * t3 * (1.0 + t * (-2.0 + t));
    const double rate_blend = t2 * (3.0 - 2.0 * t);
    const double rate_start = h * t * (1.0 + t * (-2.0 + t));
    const double rate_end = h * t2 * (t - 1.0);
    for (int c = 0; c < slots; ++c) {
        const double a0 = step.start_rate.acceleration[c];
        const double a1 = step.end_rate.acceleration[c];
        const double v0 = step.start.speed[c];
        const double v1 = step.end.speed[c];
        const double q0 = step.start.position[c];
        motion.position[c] = q0 + blend * (step.end.position[c] - q0) + start_speed * v0 +
                             end_speed * v1 + start_turn * a0 + end_turn * a1;
        motion.speed[c] = v0 + rate_blend * (v1 - v0) + rate_start * a0 + rate_end * a1;
    }
    for (int w = 0; w < kWorkCount; ++w) {
        const double p0 = step.start_rate.power[w];
        const double rise = step.end_rate.power[w] - p0;
        const double mean = (step.end.work[w] - step.start.work[w]) / h;
        const double square = 6.0 * (p0 + 0.5 * rise - mean);
        const double slope = rise - square;
        motion.work[w] = step.start.work[w] + h * t * (p0 + t * (0.5 * slope + t * square / 3.0));
    }
}

}  // namespace cambrian
