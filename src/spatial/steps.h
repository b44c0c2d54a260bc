#pragma once

// Attempts at one step: an embedded pair of Runge-Kutta formulas, or the midpoint step under the
// forces of contacts and stops (planar/README.md 13).

#include "spatial/rows.h"

#include <span>
#include <string>

namespace cambrian::spatial {

// The equation and the tick in which it is solved.
struct MotionSystem {
    const Model& model;
    const Forcing& forcing;
    double tick_length = 0.0;  // s

    // `time` is in s since the tick's start.
    void evaluate(const Motion& motion, double time, Evaluation& evaluation, MotionRate& rate,
                  const ImplicitStage* implicit = nullptr) const {
        spatial::evaluate(model, forcing, motion, time / tick_length, evaluation, rate, implicit);
    }
};

struct StepRequest {
    const Motion& start;
    const MotionRate& start_rate;  // free of stops
    double time = 0.0;             // s since the tick's start
    double length = 0.0;           // s
    double tolerance = 0.0;        // of SceneSettings
};

struct StepResult {
    Motion end;
    MotionRate end_rate;  // at the end, free of stops
    double error = 0.0;   // in tolerances; at most 1 is acceptable
    int evaluations = 0;
};

struct Integrator {
    std::string id;
    std::string label;
    // Attempts one step. Afterwards the evaluation is that of the step's end.
    void (*attempt)(const MotionSystem& system, const StepRequest& request, Evaluation& end,
                    StepResult& result) = nullptr;
    int error_order = 1;
};

std::span<const Integrator> integrators();

class MidpointStep {
public:
    static constexpr int kErrorOrder = 3;

    // Attempts one step with the rows that were selected at its start. The first half is predicted
    // with these rates. Returns false if the solver of the rows failed.
    bool attempt(const MotionSystem& system, const StepRequest& request,
                 const MotionRate& prediction, Rows& rows, Evaluation& end, StepResult& result);

    // Returns the accelerations of the step attempted last.
    const MotionRate& mean_rate() const { return mean_; }
    // Gives the rates at the ends of that step under its constant forces and efforts.
    void rates_at_ends(const Model& model, const StepRequest& request, const StepResult& result,
                       MotionRate& start, MotionRate& end) const;

private:
    double effort(int degree) const {
        return middle_.loads.effort[degree] - middle_.loads.damping[degree] * mean_.speed[degree];
    }
    void integrate_works(const Model& model, const StepRequest& request, StepResult& result) const;
    double estimate_error(const Model& model, const StepRequest& request, Rows& rows,
                          const StepResult& result) const;

    Evaluation middle_;
    Motion predicted_;
    MotionRate middle_rate_;
    MotionRate mean_;
};

}  // namespace cambrian::spatial
