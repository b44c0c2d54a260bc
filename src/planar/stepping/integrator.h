#pragma once

// The interface of integrators: one attempt at a step, with an estimate of its error. StepControl
// accepts steps and chooses their length.

#include "planar/evaluation/accelerations.h"

#include <string>

namespace cambrian {

// The motion's differential equation during one tick.
struct MotionSystem {
    const PlanarModel& model;
    const Forcing& forcing;
    double tick_length = 0.0;  // s

    // `time` is in s since the tick's start; `implicit` is as in EvaluationPoint.
    void evaluate(const Motion& motion, double time, EvaluationDetail detail,
                  EvaluationCache& cache, MotionRate& rate,
                  const ImplicitStage* implicit = nullptr) const {
        evaluate_accelerations(model, forcing, motion, {time / tick_length, detail, implicit},
                               cache, rate);
    }
};

struct StepRequest {
    const Motion& start;
    const MotionRate& start_rate;
    double time = 0.0;       // s since the tick's start
    double length = 0.0;     // s
    double tolerance = 0.0;  // of SceneSettings
};

struct StepResult {
    Motion end = {};
    MotionRate end_rate = {};  // at the end, under the same forcing
    double error = 0.0;        // of the step, in tolerances; at most 1 is acceptable
    int evaluations = 0;
};

struct IntegratorKind {
    std::string id;
    std::string label;
    // Attempts one step. Afterwards the cache is that of the step's end, with kEverything.
    void (*attempt)(const MotionSystem& system, const StepRequest& request, EvaluationCache& cache,
                    StepResult& result) = nullptr;
    int error_order = 1;    // order of the error in the step's length
    double max_step = 0.0;  // s
    // Whether steps with contact forces are midpoint steps (midpoint_step.h) instead.
    bool rows_at_middle = false;
    bool holds_stretches = true;  // whether it supports deformable parts
};

}  // namespace cambrian
