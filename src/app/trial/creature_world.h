#pragma once

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "persist/creature/creature_file.h"

#include <optional>
#include <string>

namespace cambrian {

// Returns the settings for a creature's trial: those of the file `environment` or, if it is empty,
// those that scored the creature, or else the defaults.
Result<ExperimentSettings> world_of(const CreatureDocument& document,
                                    const std::string& environment, const EvolutionKinds& kinds);

// Fails if the creature's score combines fewer trials than the one asked for, counted from 1.
Status check_trial(const std::optional<int>& asked, const std::string& creature,
                   const ExperimentSettings& settings);

}  // namespace cambrian
