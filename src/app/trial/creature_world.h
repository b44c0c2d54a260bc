#pragma once

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "persist/creature/creature_file.h"

#include <string>

namespace cambrian {

// The world a creature is put in: that of a settings file, or if that is empty the one it was
// scored in, or else the usual one.
Result<ExperimentSettings> world_of(const CreatureDocument& document,
                                    const std::string& environment, const EvolutionKinds& kinds);

}  // namespace cambrian
