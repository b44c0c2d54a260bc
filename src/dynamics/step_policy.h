#pragma once

// The choice and the judgement of steps, in the plane and in space (planar/README.md 13 to 16).

#include "core/assert.h"
#include "math/elementary.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cambrian::step_policy {

inline constexpr double kUnderflowShare = 1.0 / 32;  // of the contact step
// Upper bound of the underflow step at the default tolerance.
inline constexpr double kUnderflowStep = 1.0 / 1920;  // s
inline constexpr double kUsualTolerance = 4e-3;
inline constexpr double kNoRowsShare = 1.0 / 16;  // of the contact step
inline constexpr int kMaxUnderflows = 4;          // in a row before a step without rows
// Evaluations of so much simulated time may be spent in advance.
inline constexpr double kBudgetTime = 1.0;         // s
inline constexpr double kHalvingStep = 1.0 / 960;  // s; shorter ones are not halved
inline constexpr double kMaxDeepening = 4e-3;      // m; of the deepest contact in one step
inline constexpr double kMaxTickDeepening = 8e-3;  // m; in one tick
inline constexpr int kMaxImpacts = 8;        // per tick; later impacts are treated as slow contacts
inline constexpr double kMaxOverrun = 0.03;  // rad or m past a stop
inline constexpr double kOverrunGrowth = 0.01;      // of that in one step
inline constexpr double kStepWorkAllowance = 5e-4;  // J per (kg m/s^2)
inline constexpr double kStepGainAllowance = 3e-4;  // J per (kg m/s^2)
inline constexpr double kGainlessError = 0.05;  // of the allowed one; smaller ones add no energy
inline constexpr double kPerPosition = 10.0;    // 1 / (0.1 m or rad), of errors
// Factor of the midpoint rule's error estimate. An embedded pair continues with its better formula,
// whose error is a fraction of the estimate; the midpoint rule continues with the formula that is
// estimated.
inline constexpr double kCaution = 1.6;
inline constexpr double kMinStep = 1e-6;      // s
inline constexpr double kSliver = 1e-9;       // s; what may be left of a tick
inline constexpr double kMaxDistance = 1e6;   // m; also rad, where sine_cosine_reduced ends
inline constexpr double kMaxSpeed = 1e4;      // m/s and rad/s
inline constexpr double kScaleHeight = 0.01;  // m; the weight's part of the audit's scale

// What the settings of a scene allow.
struct Limits {
    // `order` is that of the error of steps with rows.
    Limits(const SceneSettings& settings, int order)
        : tolerance(settings.tolerance),
          contact_step(settings.contact_step),
          underflow_step(
              std::min(kUnderflowShare * contact_step,
                       kUnderflowStep * inverse_root(kUsualTolerance / tolerance, order))),
          max_evaluations(settings.max_evaluations) {}

    double tolerance;
    double contact_step;     // s; longest step with rows
    double underflow_step;   // s; shorter steps with rows count as an underflow
    double max_evaluations;  // a simulated second
};

// How far a tick has come.
struct Course {
    double length = 0.0;       // s
    double time = 0.0;         // s, since its start
    double start_depth = 0.0;  // m; of the deepest contact
    int impacts = 0;
    int underflows = 0;     // in a row
    bool detected = false;  // whether the contacts of the present state have been detected
};

// Returns a length of up to h that divides the rest of the tick evenly, so that no tiny step
// remains. After several underflows the step has no rows.
inline double even_length(const Course& tick, const Limits& limits, double h, bool& has_rows) {
    if (tick.underflows >= kMaxUnderflows) {
        has_rows = false;
        h = std::min(h, kNoRowsShare * limits.contact_step);
    }
    const double rest = tick.length - tick.time;
    const double steps = std::ceil(rest / h * (has_rows ? 0.9 : 1.0 - 1e-9));
    return rest / std::max(1.0, steps);
}

// Whether the deepest contact at the end of a step of length h is much deeper than at its start or
// the tick's.
inline bool is_too_deep(const Course& tick, double start_depth, double depth, double h) {
    if (h <= kHalvingStep || tick.underflows >= kMaxUnderflows) return false;
    return depth > start_depth + kMaxDeepening || depth > tick.start_depth + kMaxTickDeepening;
}

// Returns the factor of the step that would make the error, a share of the allowed one, just
// acceptable, within bounds. `order` is that of the error in the step.
inline double step_factor(double error, int order) {
    constexpr double kSafety = 0.9;
    constexpr double kShrinkMost = 0.2;
    constexpr double kGrowMost = 3.0;
    constexpr double kTinyError = 1e-3;  // grows the step most, whatever the order
    if (!std::isfinite(error)) return kShrinkMost;
    if (error < kTinyError) return kGrowMost;
    return std::clamp(kSafety * inverse_root(error, order), kShrinkMost, kGrowMost);
}

// With an error of up to this share of the tolerance, the next step is not shorter (for orders up
// to 5).
inline constexpr double kCalmError = 0.59;

// Returns the length of the next step after an accepted one of length h, which may be a truncated
// one of the length that was proposed (s).
inline double next_length(double error, int order, double h, double proposed, double longest) {
    const bool truncated = h < proposed;
    if (error <= kCalmError && (truncated ? proposed : h) >= longest) return longest;
    const double grown = h * step_factor(error, order);
    return std::min(truncated ? std::max(proposed, grown) : grown, longest);
}

// Whether a step is too long for constant forces, which the positive work of contacts and stops
// shows, or for its motion, which energy shows that no work explains. Works are in J, the weight in
// kg m/s^2.
template <class Gain>
bool gives_energy(double positive_work, double error, double weight, const Gain& unexplained_gain) {
    if (positive_work > kStepWorkAllowance * weight) return true;
    return error > kGainlessError && unexplained_gain() > kStepGainAllowance * weight;
}

template <class State>
void count_evaluations(State& state, int evaluations) {
    CAMBRIAN_TICK_ASSERT(evaluations > 0, "a step costs evaluations");
    state.audit.evaluations += static_cast<std::uint64_t>(evaluations);
    state.evaluation_debt += evaluations;
}

enum class Attempt : unsigned char { kAccepted, kUnderflow, kDiverged, kOverBudget };

// A step that is attempted.
struct StepKind {
    int error_order = 1;
    double longest = 0.0;  // s
    bool has_rows = false;
};

// Attempts steps, of length h (s) first and shorter ones after each that fails, until one is
// accepted. `result` is that of try_step(h).
template <class State, class StepResult, class Try, class Halve>
[[gnu::always_inline]] inline Attempt attempt(const Limits& limits, const StepKind& kind,
                                              State& state, const StepResult& result, double& h,
                                              const Try& try_step, const Halve& must_halve) {
    for (;;) {
        try_step(h);
        count_evaluations(state, result.evaluations);
        if (state.evaluation_debt > kBudgetTime * limits.max_evaluations)
            return Attempt::kOverBudget;
        if (!(result.error <= 1.0)) {
            ++state.audit.rejections;
            h *= std::min(step_factor(result.error, kind.error_order), 0.9);
            state.proposed_step = h;
            if (h < kMinStep)
                return std::isfinite(result.error) ? Attempt::kOverBudget : Attempt::kDiverged;
            if (kind.has_rows && h < limits.underflow_step) return Attempt::kUnderflow;
        } else if (must_halve(h)) {
            ++state.audit.rejections;
            h *= 0.5;
        } else {
            state.proposed_step =
                next_length(result.error, kind.error_order, h, state.proposed_step, kind.longest);
            return Attempt::kAccepted;
        }
    }
}

// Works since the start of an audit, J.
struct Works {
    double motor = 0.0, gross_motor = 0.0, drag = 0.0, pull = 0.0;
};

// Updates the works and the residual. The energy that was gained since the start is in J, the
// weight in N.
inline void note_works(const Works& works, double gained, double weight, SceneAudit& audit) {
    CAMBRIAN_TICK_ASSERT(!(audit.positive_work < 0.0), "what was given is not negative");
    audit.motor_work = works.motor;
    audit.gross_motor_work = works.gross_motor;
    audit.drag_work = works.drag;
    const double explained = works.motor + works.drag + works.pull + audit.contact_work +
                             audit.limit_work + audit.impulse_work;
    audit.energy_residual = gained - explained;
    audit.energy_scale = audit.gross_motor_work + weight * kScaleHeight;
}

// Takes over the counts, which a tick that was taken back has cost all the same.
inline void keep_counts(const SceneAudit& spent, SceneAudit& audit) {
    audit.evaluations = spent.evaluations;
    audit.steps = spent.steps;
    audit.rejections = spent.rejections;
    audit.events = spent.events;
    audit.fallbacks = spent.fallbacks;
}

}  // namespace cambrian::step_policy
