#pragma once

#include "persist/creature/creature_file.h"

#include <stop_token>

namespace cambrian {

// Returns the document of a creature's pruned twin: a child by the method "pruned", scored in the
// trial of these settings, as `cambrian verify` runs it again. Fails if it does not finish the
// trial or if a stop is requested.
Result<CreatureDocument> pruned_twin(GenomePtr genome, const CreatureDocument& original,
                                     const ExperimentSettings& settings,
                                     const EvolutionKinds& kinds, const std::stop_token& stop = {});

}  // namespace cambrian
