#pragma once

// Conditions that end a run without a window (evolution/README.md 3).

#include "evolution/individual/statistics.h"
#include "evolution/settings/experiment_settings.h"

#include <span>
#include <string_view>

namespace cambrian {

// Returns the reason to stop: "target-fitness", "evaluations" or "generations"; empty while the run
// continues.
std::string_view stop_reason(std::span<const GenerationStatistics> history,
                             const ExperimentSettings& settings);

}  // namespace cambrian
