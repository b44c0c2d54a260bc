#pragma once

// A digest of an evaluated generation. For all practical purposes, it is equal if and only if the
// same creatures had the same motion, bit by bit.

#include "core/hash.h"
#include "evolution/individual/individual.h"

#include <cstdint>
#include <span>

namespace cambrian {

// Adds uid, genome, fitness and motion of each creature, in the given order.
void add_population(Hash64& hash, std::span<const IndividualPtr> population);

std::uint64_t population_digest(std::span<const IndividualPtr> population);

}  // namespace cambrian
