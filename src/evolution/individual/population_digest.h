#pragma once

// One number for a whole evaluated generation: equal if and only if, for all practical purposes,
// the same creatures did the same, to the bit.

#include "core/hash.h"
#include "evolution/individual/individual.h"

#include <cstdint>
#include <span>

namespace cambrian {

// Uid, genome, fitness and motion of each, in the order given.
void add_population(Hash64& hash, std::span<const IndividualPtr> population);

std::uint64_t population_digest(std::span<const IndividualPtr> population);

}  // namespace cambrian
