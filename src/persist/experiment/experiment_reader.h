#pragma once

// Reads an experiment from its tables, which any program may have written. The result is complete
// and consistent; otherwise it throws DatabaseError.

#include "evolution/engine/experiment_log.h"
#include "persist/records/kept_individuals.h"
#include "persist/records/picking_record.h"
#include "persist/sqlite/database.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cambrian {

struct ReadExperiment {
    SavedExperiment saved;
    std::vector<RowRef> population;  // rows of the latest population
    PickingRecord picking;
    std::vector<JudgedIndividual> stars;
    // Creatures in grids, on the shelf or with a star.
    std::vector<std::pair<IndividualPtr, RowRef>> chosen;
};

// The tables of the database must have been checked.
ReadExperiment read_experiment(const Database& database, const EvolutionKinds& kinds);

// These functions read single parts.
SettingsPtr read_last_settings(const Database& database, const EvolutionKinds& kinds);
std::vector<GenerationStatistics> read_history(const Database& database);
// Returns the best creature of a finished generation.
JudgedIndividual read_champion(const Database& database, std::uint32_t generation,
                               const EvolutionKinds& kinds);
// Returns the version of the simulator that computed all generations; nothing if there were
// several.
std::optional<std::string> read_only_simulator(const Database& database);

}  // namespace cambrian
