#pragma once

// Where a creature comes from, in words.

#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"

#include <span>
#include <string>

namespace cambrian {

// Generation of birth, method of breeding, parents (by rank, if they live) and mutations, one line
// each. population: best first.
std::string origin_words(const Individual& individual, std::span<const IndividualPtr> population,
                         const EvolutionKinds& kinds);

}  // namespace cambrian
