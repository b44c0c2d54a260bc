#pragma once

// When an unattended run is over (evolution/README.md 3).

#include "evolution/individual/statistics.h"
#include "evolution/settings/experiment_settings.h"

#include <span>
#include <string_view>

namespace cambrian {

// Why: "target-fitness", "evaluations" or "generations"; empty while it goes on.
std::string_view stop_reason(std::span<const GenerationStatistics> history,
                             const ExperimentSettings& settings);

}  // namespace cambrian
