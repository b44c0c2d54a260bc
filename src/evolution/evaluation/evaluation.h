#pragma once

// One evaluation, the pure function every back-end calls.

#include "evolution/evaluation/hopeless.h"
#include "evolution/evaluation/probe.h"
#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "simulator/tick_checks.h"

#include <cstdint>
#include <optional>
#include <stop_token>

namespace cambrian {

// Everything one evaluation depends on, besides the experiment's settings.
struct EvaluationRequest {
    GenomePtr genome;
    std::uint64_t trial_seed = 0;
    std::uint32_t slot = 0;  // place in the generation
    std::optional<Bar> bar = std::nullopt;
    std::uint64_t expected_work = 0;            // see Individual; decides only what is begun first
    std::optional<Probe> probe = std::nullopt;  // to be tried in another world than the settings'
};

// One trial: expresses, simulates and scores. Never throws; failures are outcomes. When asked to
// stop, a long trial ends with the outcome kInterrupted.
EvaluationResult evaluate(const EvaluationRequest& request, const ExperimentSettings& settings,
                          const EvolutionKinds& kinds, const std::stop_token& stop = {});

// EvaluationResult::phenotype without a trial: creatures that have the same score the same.
std::uint64_t phenotype_of(const Genome& genome, const ExperimentSettings& settings,
                           const EvolutionKinds& kinds);

// EvaluationResult::plan without a trial.
std::uint64_t plan_of(const Genome& genome, const ExperimentSettings& settings,
                      const EvolutionKinds& kinds);

// Runs the first trial more finely (finer_settings) and scores it: what to know of a champion
// before it is saved (simulator/README.md 4).
FinerResult recompute(const Genome& genome, const ExperimentSettings& settings,
                      const EvolutionKinds& kinds, const std::stop_token& stop = {});

// The first trial once more, a byte noted for each of its ticks.
struct NotedTrial {
    std::uint64_t digest = 0;  // of the motion
    TickChecks ticks;
};
// None if physics refuses the body or a stop was asked for meanwhile.
std::optional<NotedTrial> note_ticks(const Genome& genome, const ExperimentSettings& settings,
                                     const EvolutionKinds& kinds, const std::stop_token& stop = {});

}  // namespace cambrian
