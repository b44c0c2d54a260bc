#pragma once

// The breeding methods, one file each.

#include "breeding/breeding_kind.h"

#include <cstddef>
#include <vector>

namespace cambrian {

void add_asexual(BreedingRegistry& methods);
void add_crossover(BreedingRegistry& methods);
void add_homologous_crossover(BreedingRegistry& methods);
void add_grafting(BreedingRegistry& methods);

// Returns a copy of the first parent without its name, from which every child is made.
Genome child_of(const Genome& parent);

// Crossover of parents whose nodes are aligned by position (breeding/README.md 7).
Genome cross(const Genome& first, const Genome& second, const KindCatalog& catalog,
             RandomStream& stream);

// Returns the places, ascending, at which crossover switches parents while it copies `length`
// nodes. There are one, two or three different places in 1 .. length-1 with probability 0.6, 0.3
// and 0.1, or as many as fit.
std::vector<std::size_t> draw_switch_points(std::size_t length, RandomStream& stream);

}  // namespace cambrian
