#pragma once

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <vector>

namespace cambrian {

// Returns as many random founders as the settings ask for, all of which can move. Fails if the
// settings hardly ever give such creatures.
Result<std::vector<GenomePtr>> random_founders(const ExperimentSettings& settings,
                                               const EvolutionKinds& kinds);

}  // namespace cambrian
