#pragma once

// What judging one creature may come to, whatever the settings: neither they nor a creature file
// from anywhere hold the program up for hours.

#include "simulator/trial.h"

#include <optional>
#include <string>

namespace cambrian {

inline constexpr double kMostTrialTime = 1e4;  // s, in all trials of a creature
inline constexpr double kMostTrialWork = 2e8;  // evaluations of the accelerations in them

// What is too much of the trials and how much is allowed; nothing if they keep to both limits.
std::optional<std::string> trial_excess(const TrialWorld& world);

}  // namespace cambrian
