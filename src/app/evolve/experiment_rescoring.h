#pragma once

// An experiment whose scores come from another version of the simulator.

#include "evolution/evaluation/evaluation_backend.h"
#include "persist/experiment/experiment_file.h"

#include <filesystem>
#include <optional>
#include <stop_token>

namespace cambrian {

struct RescoredExperiment {
    std::string simulator;        // that computed the generation before
    JudgedIndividual before;      // best of that generation
    std::optional<double> again;  // what the same creature scores now, if it survived
    JudgedIndividual after;       // best of the generation that was judged now
};

// Judges everyone of the generation at hand, survivors included, and keeps that generation in the
// file, the command in its journal. Fails, leaving the experiment as it is, if none of its
// generations is finished or a stop was asked for meanwhile.
Result<RescoredExperiment> rescore_experiment(const std::filesystem::path& path,
                                              const EvolutionKinds& kinds,
                                              EvaluationBackend& backend,
                                              const std::stop_token& stop);

}  // namespace cambrian
