#pragma once

// Computes an experiment again from its beginning, with every command at its time.

#include "evolution/engine/experiment_log.h"
#include "evolution/evaluation/evaluation_backend.h"
#include "simulator/trial_watch.h"

#include <cstdint>
#include <optional>

namespace cambrian {

struct ReplayOutcome {
    std::uint32_t generations = 0;           // that were the same
    std::optional<std::uint32_t> different;  // the first that was not
    bool stopped = false;
};

// `watch` is told the number of generations that are done.
ReplayOutcome replay_experiment(const SavedExperiment& saved, const EvolutionKinds& kinds,
                                EvaluationBackend& backend, const TrialWatch& watch);

}  // namespace cambrian
