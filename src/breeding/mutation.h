#pragma once

#include "breeding/mutation_kind.h"
#include "breeding/mutation_settings.h"

#include <vector>

namespace cambrian {

// Draws the number of mutations of an offspring by the settings' scheme.
int draw_mutation_count(const MutationSettings& settings, RandomStream& stream);

// Mutates a valid genome by the scheme of breeding/README.md 1. Each counted mutation changes the
// genome's hash after repair, and the genome stays valid. Returns the mutations in order. `extra`
// mutations are made besides those that the scheme draws, even if the scheme is "none".
std::vector<MutationRecord> mutate(Genome& genome, const MutationSettings& settings,
                                   const MutationRegistry& kinds, const MutationContext& context,
                                   RandomStream& stream, int extra = 0);

}  // namespace cambrian
