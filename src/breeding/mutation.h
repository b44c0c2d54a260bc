#pragma once

#include "breeding/mutation_kind.h"
#include "breeding/mutation_settings.h"

#include <vector>

namespace cambrian {

// Draws how many mutations an offspring gets by the settings' scheme.
int draw_mutation_count(const MutationSettings& settings, RandomStream& stream);

// Mutates a valid genome by the scheme of breeding/README.md 1: each counted mutation changes the
// genome's hash after repair. The genome stays valid. Returns what was done, in order. extra:
// mutations besides those the scheme draws, even if that is "none".
std::vector<MutationRecord> mutate(Genome& genome, const MutationSettings& settings,
                                   const MutationRegistry& kinds, const MutationContext& context,
                                   RandomStream& stream, int extra = 0);

}  // namespace cambrian
