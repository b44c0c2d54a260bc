#pragma once

// Description of a creature's origin.

#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"

#include <span>
#include <string>

namespace cambrian {

// Returns the label of a breeding method: "Homologous crossover", "Edited".
std::string method_words(const std::string& method, const EvolutionKinds& kinds);

// Returns generation of birth, breeding method, parents and mutations, one per line. Living parents
// are named by rank. `population` is sorted, best first.
std::string origin_words(const Individual& individual, std::span<const IndividualPtr> population,
                         const EvolutionKinds& kinds);

}  // namespace cambrian
