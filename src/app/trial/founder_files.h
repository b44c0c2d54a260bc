#pragma once

// Creature files that a command takes as founders.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "persist/creature/creature_file.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// The most founders there may be, the setting that says so, and the option that names them.
struct FounderPlaces {
    std::string_view setting;
    int count = 0;
    std::string_view option = "--founders";
};

// Reads the files and prints their warnings. Fails if there are more of them than places.
Result<std::vector<CreatureDocument>> load_founders(std::span<const std::string> files,
                                                    const FounderPlaces& places,
                                                    const ExperimentSettings& settings,
                                                    const EvolutionKinds& kinds);
std::vector<GenomePtr> genomes_of(std::span<const CreatureDocument> founders);

// Says that a settings file is missing, and if one is among the founders, how it came there.
std::string no_settings_file(const std::vector<std::string>& founders);

}  // namespace cambrian
