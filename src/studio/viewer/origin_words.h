#pragma once

// Where a creature comes from, in words.

#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"

#include <span>
#include <string>

namespace cambrian {

// When it was born, how it was bred, its parents (by their rank, if they live) and its mutations, a
// line each. population: best first.
std::string origin_words(const Individual& individual, std::span<const IndividualPtr> population,
                         const EvolutionKinds& kinds);

}  // namespace cambrian
