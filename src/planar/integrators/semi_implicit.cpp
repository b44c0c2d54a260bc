// Semi-implicit (symplectic) Euler with a fixed step: v1 = v0 + h a0, q1 = q0 + h v1. It is of
// first order without error control, for comparison and debugging and not for evolution.

#include "planar/integrators/builtin_integrators.h"

namespace cambrian {
namespace {

void attempt_semi_implicit_step(const MotionSystem& system, const StepRequest& request,
                                EvaluationCache& cache, StepResult& result) {
    const double h = request.length;
    for (int c = 0; c < coordinate_slots(system.model); ++c) {
        result.end.speed[c] = request.start.speed[c] + h * request.start_rate.acceleration[c];
        result.end.position[c] = request.start.position[c] + h * result.end.speed[c];
    }
    system.evaluate(result.end, request.time + h, EvaluationDetail::kEverything, cache,
                    result.end_rate);
    for (int w = 0; w < kWorkCount; ++w)
        result.end.work[w] = request.start.work[w] +
                             0.5 * h * (request.start_rate.power[w] + result.end_rate.power[w]);
    result.error = 0.0;
    result.evaluations = 1;
}

}  // namespace

void add_semi_implicit(IntegratorRegistry& integrators) {
    integrators.add(
        {"semi-implicit", "Semi-implicit Euler", attempt_semi_implicit_step, 1, 1.0 / 240});
}

}  // namespace cambrian
