#pragma once

// The museum of champions (persist/creature/champion_museum.h) at the beginning and at the end of a
// run without a window.

#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "persist/creature/creature_file.h"

#include <string>
#include <vector>

namespace cambrian {

// Where founders come from.
struct FounderSources {
    const std::vector<std::string>& files;
    const std::string& museum;  // folder; empty for none
};

// Returns the creatures of the files and, if the settings say so and as far as there are places,
// some of the museum. Says so if the museum has none.
Result<std::vector<GenomePtr>> founders_of(const FounderSources& sources,
                                           const ExperimentSettings& settings,
                                           const EvolutionKinds& kinds);

// Puts the champion into the museum, unless its path is empty, and says so.
Status exhibit(const std::string& museum, const CreatureDocument& champion,
               const EvolutionKinds& kinds);

}  // namespace cambrian
