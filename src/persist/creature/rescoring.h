#pragma once

// Finds and replaces scores of another version of the simulator.

#include "evolution/engine/experiment_log.h"
#include "persist/creature/creature_file.h"

#include <optional>
#include <stop_token>
#include <string>

namespace cambrian {

// Returns "scored by simulator 0.9, this is 1.0", or nothing if this version of the simulator gave
// the score.
std::optional<std::string> other_simulator(const CreatureDocument& document);
std::optional<std::string> other_simulator(const std::string& version);

// Returns the same for an experiment whose newest creatures may have scores of another version.
std::optional<std::string> other_simulator(const SavedExperiment& saved);

// Returns the version of the simulator that scored, in one generation, a creature born in another.
std::string scored_by(const SavedExperiment& saved, std::uint32_t born, std::uint32_t generation);

// Runs the scored trial with this version of the simulator. The document must have a score.
EvaluationResult run_scored_trial(const CreatureDocument& document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop = {});

// Returns the creature with the score, motion and check bytes that its scored trial gives in this
// version of the simulator. Fails if the document has no score, if the creature can no longer
// finish the trial, or if a stop is requested.
Result<CreatureDocument> rescored(CreatureDocument document, const EvolutionKinds& kinds,
                                  const std::stop_token& stop = {});

}  // namespace cambrian
