#pragma once

// Mouths and what they digest (preserve/README.md 4).

#include "creature/kinds.h"
#include "creature/phenotype.h"

#include <cstddef>
#include <vector>

namespace cambrian {

struct Mouth {
    std::size_t part = 0;
    double diet = 0.0;   // 0 means plants, 1 means flesh
    double width = 0.0;  // m, of the part
};

// Returns the mouths of a body; its root part if it has none.
std::vector<Mouth> mouths_of(const Phenotype& phenotype, const OrganRegistry& organs);

// Return the share of eaten energy that a mouth with that diet gains.
double share_of_plants(double diet);
double share_of_flesh(double diet);

}  // namespace cambrian
