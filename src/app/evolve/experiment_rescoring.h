#pragma once

// Evaluates an experiment again whose scores come from another version of the simulator.

#include "evolution/evaluation/evaluation_backend.h"
#include "persist/experiment/experiment_file.h"

#include <filesystem>
#include <optional>
#include <stop_token>

namespace cambrian {

struct RescoredExperiment {
    std::string simulator;        // version that computed the last generation before
    JudgedIndividual before;      // best creature of that generation
    std::optional<double> again;  // new score of the same creature, if it survived
    JudgedIndividual after;       // best creature of the generation evaluated now
};

// Breeds the next generation, evaluates all its creatures, survivors included, and adds it to the
// file with the command in its journal. Does nothing, and returns nothing, if this version of the
// simulator gave all scores of the last generation. Fails without changing the experiment if it has
// no finished generation or if a stop is requested.
Result<std::optional<RescoredExperiment>> rescore_experiment(const std::filesystem::path& path,
                                                             const EvolutionKinds& kinds,
                                                             EvaluationBackend& backend,
                                                             const std::stop_token& stop);

}  // namespace cambrian
