#pragma once

// Energy that a resident gains and loses in a tick (preserve/README.md 3 and 4). None of these
// functions makes or destroys energy.

#include "math/torus.h"
#include "preserve/life/resident.h"
#include "preserve/world/food.h"

namespace cambrian {

// Eats what its mouths reach. Returns the energy that was not digested.
Energy eat(Resident& resident, Food& plants, Food& flesh);

// Returns how near (m) a mouth must be to a part to bite it: solid bodies hardly overlap.
double bite_distance(const PreserveSettings& laws);
// Returns how near (m) its bounds must be to another's, each grown by this, for a bite.
double bite_reach(const Resident& resident, const PreserveSettings& laws);

// All that bites depend on besides the two.
struct BiteRules {
    const PreserveSettings& laws;
    std::uint64_t tick;
    Torus torus;  // parts are bitten at their nearest images
};

// Lets one bite the other for a tick, where a mouth is that near to a part or rammed it. Parents
// and young children do not bite each other.
void bite(Resident& biter, Resident& victim, const BiteRules& rules, Food& flesh);

// Spends the energy of the last tick's work and of upkeep, at most all it has in store. Returns it.
Energy spend(Resident& resident, const PreserveSettings& laws, std::uint64_t tick);

// Turns all energy of a body into flesh where its parts are.
void decay_to_flesh(Resident& resident, Food& flesh);

}  // namespace cambrian
