#pragma once

// Offspring of residents: breeding and mutation as in an experiment.

#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "preserve/life/resident.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace cambrian {

// Living creatures in ascending order of their numbers.
using Residents = std::vector<std::unique_ptr<Resident>>;

// Returns the life of a child of a resident, not yet born: its parents, method, mutations, genome
// and uid. `attempt` numbers all attempts of the preserve at a birth; `stream` is the attempt's.
Life conceive(const Resident& parent, const Residents& all, const ExperimentSettings& settings,
              const EvolutionKinds& kinds, std::uint64_t attempt, std::uint64_t tick,
              RandomStream& stream);

}  // namespace cambrian
