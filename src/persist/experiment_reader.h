#pragma once

// Reads an experiment from its tables, whoever wrote them: what it gives is whole and consistent.
// Throws DatabaseError otherwise.

#include "evolution/experiment_log.h"
#include "persist/database.h"
#include "persist/kept_individuals.h"

#include <vector>

namespace cambrian {

struct ReadExperiment {
    SavedExperiment saved;
    std::vector<RowRef> population;  // rows of the latest one
};

// Of a database whose tables were checked.
ReadExperiment read_experiment(const Database& database, const EvolutionKinds& kinds);

}  // namespace cambrian
