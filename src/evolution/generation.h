#pragma once

#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

// The next generation of a ranked one: survivors as they are, then offspring, then newcomers; a
// pure function of its arguments but for the selection's memory, which it carries on. `generation`
// is the number of the one to make.
std::vector<IndividualPtr> next_generation(std::span<const IndividualPtr> ranked,
                                           const ExperimentSettings& settings,
                                           const EvolutionKinds& kinds, std::uint32_t generation,
                                           SelectionMemory& memory);

// Who of the ranking would live on in that generation, as indices in ascending order.
std::vector<std::size_t> survivors_of(std::span<const IndividualPtr> ranked,
                                      const ExperimentSettings& settings,
                                      const EvolutionKinds& kinds, std::uint32_t generation,
                                      SelectionMemory memory);

// Who has a child, and how.
struct Mating {
    const IndividualPtr& first;
    const IndividualPtr& second;  // not looked at by methods of one parent
    const BreedingKind& method;
    int extra_mutations = 0;  // besides those the settings draw
};

// The child for a place in a generation, mutated, not yet evaluated. `breeding` is drawn from.
IndividualPtr make_child(const Mating& mating, const ExperimentSettings& settings,
                         const EvolutionKinds& kinds, std::uint32_t generation, std::uint64_t child,
                         RandomStream& breeding);

// A random creature for a place in a generation.
IndividualPtr make_newcomer(const ExperimentSettings& settings, const EvolutionKinds& kinds,
                            std::uint32_t generation, std::uint64_t child);

// A creature of a given genome for a place in a generation.
Individual make_individual(GenomePtr genome, const ExperimentSettings& settings,
                           std::uint32_t generation, std::uint64_t child, std::string method);

}  // namespace cambrian
