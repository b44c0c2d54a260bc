#pragma once

// Explicit Runge-Kutta pairs whose last stage is the step's end, so that it serves as the first
// stage of the next step. A Tableau has kStages, the kNodes c, the kRows of a (the last one holds
// the propagated weights b) and the kErrors b - b^.

#include "dynamics/integrator.h"

namespace cambrian {

template <class Tableau>
void attempt_embedded_step(const MotionSystem& system, const StepRequest& request, Frame& frame,
                           StepResult& result) {
    constexpr std::size_t stages = Tableau::kStages;
    const int n = coordinate_count(system.model);
    const double h = request.length;
    Motion stage[stages];
    MotionRate rate[stages];
    const auto speed_of = [&](std::size_t s) -> const PerCoordinate& {
        return s == 0 ? request.start.speed : stage[s].speed;
    };
    const auto rate_of = [&](std::size_t s) -> const MotionRate& {
        return s == 0 ? request.start_rate : rate[s];
    };
    for (std::size_t s = 1; s < stages; ++s) {
        const bool last = s == stages - 1;
        Motion& motion = last ? result.end : stage[s];
        for (int c = 0; c < n; ++c) {
            double speed = 0.0;
            double acceleration = 0.0;
            for (std::size_t j = 0; j < s; ++j) {
                speed += Tableau::kRows[s][j] * speed_of(j)[c];
                acceleration += Tableau::kRows[s][j] * rate_of(j).acceleration[c];
            }
            motion.position[c] = request.start.position[c] + h * speed;
            motion.speed[c] = request.start.speed[c] + h * acceleration;
        }
        system.evaluate(motion, request.time + Tableau::kNodes[s] * h, frame,
                        last ? result.end_rate : rate[s]);
    }
    PerCoordinate position_error;
    PerCoordinate speed_error;
    for (int c = 0; c < n; ++c) {
        double position = Tableau::kErrors[stages - 1] * result.end.speed[c];
        double speed = Tableau::kErrors[stages - 1] * result.end_rate.acceleration[c];
        for (std::size_t j = 0; j < stages - 1; ++j) {
            position += Tableau::kErrors[j] * speed_of(j)[c];
            speed += Tableau::kErrors[j] * rate_of(j).acceleration[c];
        }
        position_error[c] = h * position;
        speed_error[c] = h * speed;
    }
    for (int w = 0; w < kWorkCount; ++w) {
        double power = 0.0;
        for (std::size_t j = 0; j < stages - 1; ++j)
            power += Tableau::kRows[stages - 1][j] * rate_of(j).power[w];
        result.end.work[w] = request.start.work[w] + h * power;
    }
    result.error = step_error(n, position_error, speed_error, result.end.speed, request.tolerance);
    result.evaluations = stages - 1;
}

}  // namespace cambrian
