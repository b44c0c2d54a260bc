#pragma once

// Creatures with more or fewer senses, for measuring what senses cost.

#include "creature/phenotype.h"

#include <string_view>

namespace cambrian::bench {

// Returns the creature with one more sensor of every channel, on its parts in turn. No neuron reads
// them.
Phenotype with_every_channel(Phenotype creature, const Kinds& kinds);

// Returns the creature with the sensors it has ("all"), with joint and contact sensors only
// ("1994") or with none ("none"). Neurons that read another sensor read 0.
Phenotype with_senses(Phenotype creature, const Kinds& kinds, std::string_view senses);

}  // namespace cambrian::bench
