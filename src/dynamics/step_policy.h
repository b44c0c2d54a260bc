#pragma once

// The choice and the judgement of steps, in the plane and in space (planar/README.md 13 to 16).

#include "math/elementary.h"
#include "world/physics_scene.h"

#include <algorithm>
#include <cmath>

namespace cambrian::step_policy {

inline constexpr double kUnderflowShare = 1.0 / 32;  // of the contact step
// Upper bound of the underflow step at the default tolerance.
inline constexpr double kUnderflowStep = 1.0 / 1920;  // s
inline constexpr double kUsualTolerance = 4e-3;
inline constexpr double kNoRowsShare = 1.0 / 16;  // of the contact step
inline constexpr int kMaxUnderflows = 4;          // in a row before a step without rows
// Evaluations of so much simulated time may be spent in advance.
inline constexpr double kBudgetTime = 1.0;          // s
inline constexpr double kHalvingStep = 1.0 / 960;   // s; shorter ones are not halved
inline constexpr double kMaxOverrun = 0.03;         // rad or m past a stop
inline constexpr double kOverrunGrowth = 0.01;      // of that in one step
inline constexpr double kStepWorkAllowance = 5e-4;  // J per (kg m/s^2)
inline constexpr double kStepGainAllowance = 3e-4;  // J per (kg m/s^2)
inline constexpr double kGainlessError = 0.05;  // of the allowed one; smaller ones add no energy
inline constexpr double kMinStep = 1e-6;        // s
inline constexpr double kSliver = 1e-9;         // s; what may be left of a tick
inline constexpr double kMaxDistance = 1e6;     // m; also rad, where sine_cosine_reduced ends
inline constexpr double kMaxSpeed = 1e4;        // m/s and rad/s
inline constexpr double kScaleHeight = 0.01;    // m; the weight's part of the audit's scale

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

// Takes over the counts, which a tick that was taken back has cost all the same.
inline void keep_counts(const SceneAudit& spent, SceneAudit& audit) {
    audit.evaluations = spent.evaluations;
    audit.steps = spent.steps;
    audit.rejections = spent.rejections;
    audit.events = spent.events;
    audit.fallbacks = spent.fallbacks;
}

}  // namespace cambrian::step_policy
