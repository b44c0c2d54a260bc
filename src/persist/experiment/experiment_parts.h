#pragma once

// Reads single parts of an experiment file. Time and memory do not grow with the rest of the file,
// and the file does not change.

#include "core/result.h"
#include "evolution/engine/experiment_log.h"
#include "evolution/kinds/evolution_kinds.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

// Returns the settings at the end of the run.
Result<SettingsPtr> load_last_settings(const std::filesystem::path& path,
                                       const EvolutionKinds& kinds);

// Returns the statistics of every finished generation; fails if there is none.
Result<std::vector<GenerationStatistics>> load_history(const std::filesystem::path& path);

// Returns at most `most` generations from the first to the last one, evenly spread, in order.
std::vector<std::uint32_t> spread_generations(std::uint32_t last, std::size_t most);

struct KeptChampion {
    JudgedIndividual creature;
    std::string simulator;  // version of the simulator that gave its score
};

// Returns the best creature of a generation, by default the last finished one; fails if there is
// none.
Result<KeptChampion> load_champion(const std::filesystem::path& path,
                                   const std::optional<std::uint32_t>& generation,
                                   const EvolutionKinds& kinds);

// Copies an experiment to a file that does not exist yet. The experiment may be in use.
Status copy_experiment(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace cambrian
