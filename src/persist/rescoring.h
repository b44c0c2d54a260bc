#pragma once

// Scores given by another version of the simulator: how to tell them, and how to replace them.

#include "persist/creature_file.h"

#include <optional>
#include <stop_token>
#include <string>

namespace cambrian {

// "scored by simulator 0.9, this is 1.0"; nothing if this program's simulator gave the score.
std::optional<std::string> other_simulator(const ScoredRecord& scored);

// What the scored trial comes to in this program's simulator. The document must hold a score.
EvaluationResult run_scored_trial(const CreatureDocument& document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop = {});

// The same creature with the score, motion and further notes that the scored trial gives in this
// program's simulator. Fails if the document holds no score, if the creature can no longer finish
// the trial, or if a stop was asked for meanwhile.
Result<CreatureDocument> rescored(CreatureDocument document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop = {});

}  // namespace cambrian
