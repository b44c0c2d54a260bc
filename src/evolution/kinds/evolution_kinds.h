#pragma once

#include "breeding/breeding_kind.h"
#include "breeding/mutation_kind.h"
#include "creature/kinds.h"
#include "evolution/selections/selection.h"
#include "goals/goal.h"

namespace cambrian {

// All registries on which an experiment depends. The application fills them once.
struct EvolutionKinds {
    Kinds creature;
    MutationRegistry mutations;
    BreedingRegistry breeding;
    GoalRegistry goals;
    SelectionRegistry selections;
};

// Also tells the catalog of genes which breeding methods there are.
EvolutionKinds make_evolution_kinds(Kinds creature, MutationRegistry mutations,
                                    BreedingRegistry breeding, GoalRegistry goals,
                                    SelectionRegistry selections);

}  // namespace cambrian
