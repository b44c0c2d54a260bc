#pragma once

// Scores given by another version of the simulator: how to tell them, and how to replace them.

#include "evolution/engine/experiment_log.h"
#include "persist/creature/creature_file.h"

#include <optional>
#include <stop_token>
#include <string>

namespace cambrian {

// "scored by simulator 0.9, this is 1.0"; nothing if this program's simulator gave the score.
std::optional<std::string> other_simulator(const ScoredRecord& scored);
std::optional<std::string> other_simulator(const std::string& version);

// The same for an experiment: whether its newest creatures may still have scores of another one.
std::optional<std::string> other_simulator(const SavedExperiment& saved);

// The version that gave a creature, born in some generation, the score it has in another.
std::string scored_by(const SavedExperiment& saved, std::uint32_t born, std::uint32_t generation);

// What the scored trial comes to in this program's simulator. The document must hold a score.
EvaluationResult run_scored_trial(const CreatureDocument& document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop = {});

// The same creature with the score, motion and further notes that the scored trial gives in this
// program's simulator. Fails if the document holds no score, if the creature can no longer finish
// the trial, or if a stop was asked for meanwhile.
Result<CreatureDocument> rescored(CreatureDocument document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop = {});

}  // namespace cambrian
