#pragma once

// Explicit Runge-Kutta pairs whose last stage is the step's end, so that it serves as the first
// stage of the next step. A Tableau has kStages, the nodes c, the rows a (the last one holds the
// propagated weights) and the error weights e = b - b^.

#include "dynamics/integrator.h"

namespace cambrian {

template <class Tableau>
void attempt_embedded_step(const MotionSystem& system, const StepRequest& request, Frame& frame,
                           StepResult& result) {
    constexpr std::size_t kStages = Tableau::kStages;
    const int n = coordinate_count(system.model);
    const double h = request.length;
    Motion stage[kStages];
    MotionRate rate[kStages];
    const auto speed_of = [&](std::size_t s) -> const PerCoordinate& {
        return s == 0 ? request.start.speed : stage[s].speed;
    };
    const auto rate_of = [&](std::size_t s) -> const MotionRate& {
        return s == 0 ? request.start_rate : rate[s];
    };
    for (std::size_t s = 1; s < kStages; ++s) {
        const bool last = s == kStages - 1;
        Motion& motion = last ? result.end : stage[s];
        for (int c = 0; c < n; ++c) {
            double speed = 0.0;
            double acceleration = 0.0;
            for (std::size_t j = 0; j < s; ++j) {
                speed += Tableau::a[s][j] * speed_of(j)[c];
                acceleration += Tableau::a[s][j] * rate_of(j).acceleration[c];
            }
            motion.position[c] = request.start.position[c] + h * speed;
            motion.speed[c] = request.start.speed[c] + h * acceleration;
        }
        system.evaluate(motion, request.time + Tableau::c[s] * h, frame,
                        last ? result.end_rate : rate[s]);
    }
    PerCoordinate position_error;
    PerCoordinate speed_error;
    for (int c = 0; c < n; ++c) {
        double position = Tableau::e[kStages - 1] * result.end.speed[c];
        double speed = Tableau::e[kStages - 1] * result.end_rate.acceleration[c];
        for (std::size_t j = 0; j < kStages - 1; ++j) {
            position += Tableau::e[j] * speed_of(j)[c];
            speed += Tableau::e[j] * rate_of(j).acceleration[c];
        }
        position_error[c] = h * position;
        speed_error[c] = h * speed;
    }
    for (int w = 0; w < kWorkCount; ++w) {
        double power = 0.0;
        for (std::size_t j = 0; j < kStages - 1; ++j)
            power += Tableau::a[kStages - 1][j] * rate_of(j).power[w];
        result.end.work[w] = request.start.work[w] + h * power;
    }
    result.error = step_error(n, position_error, speed_error, result.end.speed, request.tolerance);
    result.evaluations = kStages - 1;
}

}  // namespace cambrian
