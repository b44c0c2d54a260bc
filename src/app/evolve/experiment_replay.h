#pragma once

// Computes an experiment again from its start, with each recorded command at its generation.

#include "evolution/engine/experiment_log.h"
#include "evolution/evaluation/evaluation_backend.h"
#include "simulator/trial_watch.h"

#include <cstdint>
#include <optional>

namespace cambrian {

struct ReplayOutcome {
    std::uint32_t generations = 0;           // number of generations that are identical
    std::optional<std::uint32_t> different;  // first generation that differs, if any
    bool stopped = false;
};

// Reports the number of finished generations to `watch`.
ReplayOutcome replay_experiment(const SavedExperiment& saved, const EvolutionKinds& kinds,
                                EvaluationBackend& backend, const TrialWatch& watch);

}  // namespace cambrian
