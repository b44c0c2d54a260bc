#pragma once

// The largest work of evaluating one creature with any settings. It keeps settings and creature
// files of others from blocking the program for hours.

#include "simulator/trial.h"

#include <optional>
#include <string>

namespace cambrian {

inline constexpr double kMostTrialTime = 1e4;  // s, in all trials of a creature
inline constexpr double kMostTrialWork = 2e8;  // evaluations of the accelerations in them

// Returns which limit the trials exceed, and its value; nothing if they keep both.
std::optional<std::string> trial_excess(const TrialWorld& world);

}  // namespace cambrian
