#pragma once

// One evaluation: the pure function that every back-end calls.

#include "creature/lesion.h"
#include "evolution/evaluation/early_termination.h"
#include "evolution/evaluation/probe.h"
#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "simulator/tick_checks.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace cambrian {

// Everything one evaluation depends on, besides the experiment's settings.
struct EvaluationRequest {
    GenomePtr genome;
    std::uint64_t trial_seed = 0;
    std::uint32_t slot = 0;  // index of the creature in the generation
    std::optional<TerminationThreshold> threshold = std::nullopt;
    std::uint64_t expected_work = 0;  // see Individual; affects only the order of evaluation
    std::optional<Probe> probe = std::nullopt;  // world that replaces the settings' one
    std::vector<Lesion> lesions = {};           // inflicted on the grown creature
};

// Returns the creature that a genome becomes, with these lesions.
std::shared_ptr<const Phenotype> grow(const Genome& genome, const ExperimentSettings& settings,
                                      const EvolutionKinds& kinds,
                                      std::span<const Lesion> lesions = {});

// Runs one trial: it expresses, simulates and scores. It never throws; failures are outcomes. A
// long trial that is asked to stop ends with the outcome kInterrupted.
EvaluationResult evaluate(const EvaluationRequest& request, const ExperimentSettings& settings,
                          const EvolutionKinds& kinds, const std::stop_token& stop = {});

// An evaluation, with what the trial adds to a score of all trials (GoalKind::shares).
struct JudgedTrial {
    EvaluationResult result;
    std::vector<double> shares = {};
};
JudgedTrial judge_trial(const EvaluationRequest& request, const ExperimentSettings& settings,
                        const EvolutionKinds& kinds, const std::stop_token& stop = {});

// The hashes of an EvaluationResult. Creatures of the same phenotype have the same score.
struct PhenotypeHashes {
    std::uint64_t phenotype = 0;
    std::uint64_t plan = 0;
};
// Computes them without a trial.
PhenotypeHashes hashes_of(const Genome& genome, const ExperimentSettings& settings,
                          const EvolutionKinds& kinds);

// Runs and scores the first trial with finer settings (finer_settings), as for every champion that
// is saved (simulator/README.md 4).
FinerResult recompute(const Genome& genome, const ExperimentSettings& settings,
                      const EvolutionKinds& kinds, const std::stop_token& stop = {});

// Runs the first trial again and records one byte for each tick.
struct NotedTrial {
    std::uint64_t digest = 0;  // digest of the motion
    TickChecks ticks;
};
// Returns nothing if physics rejects the body or a stop is requested.
std::optional<NotedTrial> note_ticks(const Genome& genome, const ExperimentSettings& settings,
                                     const EvolutionKinds& kinds, const std::stop_token& stop = {});

}  // namespace cambrian
