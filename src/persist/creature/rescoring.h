#pragma once

// Finds and replaces scores of another version of the simulator.

#include "evolution/engine/experiment_log.h"
#include "persist/creature/creature_file.h"

#include <optional>
#include <stop_token>
#include <string>

namespace cambrian {

// "scored by simulator 0.9, this is 1.0"; nothing if this program's simulator gave the score.
std::optional<std::string> other_simulator(const CreatureDocument& document);
std::optional<std::string> other_simulator(const std::string& version);

// Says the same of an experiment whose newest creatures may have scores of another version.
std::optional<std::string> other_simulator(const SavedExperiment& saved);

// The simulator version that gave the score in one generation to a creature born in another.
std::string scored_by(const SavedExperiment& saved, std::uint32_t born, std::uint32_t generation);

// The result of the scored trial in this program's simulator. The document must have a score.
EvaluationResult run_scored_trial(const CreatureDocument& document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop = {});

// The same creature with the score, motion and further notes that the scored trial gives in this
// program's simulator. Fails if the document holds no score, if the creature can no longer finish
// the trial, or if a stop was asked for meanwhile.
Result<CreatureDocument> rescored(CreatureDocument document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop = {});

}  // namespace cambrian
