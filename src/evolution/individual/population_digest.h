#pragma once

// One number for an evaluated generation. For all practical purposes, it is equal if and only if
// the same creatures moved the same, to the bit.

#include "core/hash.h"
#include "evolution/individual/individual.h"

#include <cstdint>
#include <span>

namespace cambrian {

// Uid, genome, fitness and motion of each, in the order given.
void add_population(Hash64& hash, std::span<const IndividualPtr> population);

std::uint64_t population_digest(std::span<const IndividualPtr> population);

}  // namespace cambrian
