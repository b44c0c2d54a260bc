#include "evolution/kinds/evolution_kinds.h"

#include <utility>

namespace cambrian {

EvolutionKinds make_evolution_kinds(Kinds creature, MutationRegistry mutations,
                                    BreedingRegistry breeding, GoalRegistry goals,
                                    SelectionRegistry selections) {
    creature.catalog.reproductions = reproductions_of(breeding);
    return {.creature = std::move(creature),
            .mutations = std::move(mutations),
            .breeding = std::move(breeding),
            .goals = std::move(goals),
            .selections = std::move(selections)};
}

}  // namespace cambrian
