#pragma once

// Limits on the work of evaluating one creature, for any settings. They prevent settings and
// creature files from other people from blocking the program for hours.

#include "simulator/trial.h"

#include <optional>
#include <string>

namespace cambrian {

inline constexpr double kMostTrialTime = 1e4;  // s, total of all trials of a creature
// Evaluations of the accelerations in all trials of a creature.
inline constexpr double kMostTrialWork = 2e8;

// Returns which limit the trials exceed and by how much; nothing if they keep both.
std::optional<std::string> trial_excess(const TrialWorld& world);

// Returns the largest whole number of evaluations per simulated second that keeps the limit on
// work.
double most_evaluations(const TrialSettings& trial);

}  // namespace cambrian
