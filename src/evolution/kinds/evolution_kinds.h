#pragma once

#include "breeding/breeding_kind.h"
#include "breeding/mutation_kind.h"
#include "creature/kinds.h"
#include "evolution/selections/selection.h"
#include "goals/goal.h"

namespace cambrian {

// Every registry an experiment can draw from; built once by the application.
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
