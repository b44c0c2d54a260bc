#pragma once

#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

// Makes the next generation from a ranked one: unchanged survivors, then offspring, then random
// immigrants. `generation` is the number of the new one. It is a pure function except for the
// selection's memory, which it updates.
std::vector<IndividualPtr> next_generation(std::span<const IndividualPtr> ranked,
                                           const ExperimentSettings& settings,
                                           const EvolutionKinds& kinds, std::uint32_t generation,
                                           SelectionMemory& memory);

// Returns the creatures of the ranking that survive in that generation, as ascending indices.
std::vector<std::size_t> survivors_of(std::span<const IndividualPtr> ranked,
                                      const ExperimentSettings& settings,
                                      const EvolutionKinds& kinds, std::uint32_t generation,
                                      SelectionMemory memory);

// The parents of a child and its breeding method.
struct ParentPair {
    const IndividualPtr& first;
    const IndividualPtr& second;  // ignored by methods of one parent
    const BreedingKind& method;
    int extra_mutations = 0;  // besides those that the settings draw
    bool tuned = false;       // the child is tuned instead of mutated
};

// Returns the child for a place in a generation, bred and mutated or tuned but not evaluated.
// Random numbers come from `breeding`.
IndividualPtr make_child(const ParentPair& pair, const ExperimentSettings& settings,
                         const EvolutionKinds& kinds, std::uint32_t generation, std::uint64_t child,
                         RandomStream& breeding);

// Returns a random creature for a place in a generation.
IndividualPtr make_immigrant(const ExperimentSettings& settings, const EvolutionKinds& kinds,
                             std::uint32_t generation, std::uint64_t child);

// Returns a creature with a given genome for a place in a generation.
Individual make_individual(GenomePtr genome, const ExperimentSettings& settings,
                           std::uint32_t generation, std::uint64_t child, std::string method);

}  // namespace cambrian
