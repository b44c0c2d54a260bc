#pragma once

// The breeding methods; one file each.

#include "breeding/breeding_kind.h"

#include <cstddef>
#include <vector>

namespace cambrian {

void add_asexual(BreedingRegistry& methods);
void add_crossover(BreedingRegistry& methods);
void add_homologous_crossover(BreedingRegistry& methods);
void add_grafting(BreedingRegistry& methods);

// The start of every child: a copy of the first parent without its name.
Genome child_of(const Genome& parent);

// Crossover of parents whose nodes are aligned by position, breeding/README.md 7.
Genome cross(const Genome& first, const Genome& second, const KindCatalog& catalog,
             RandomStream& stream);

// The places at which crossover changes parents while it copies `length` nodes, ascending: one, two
// or three different places in 1 .. length-1 with probability 0.6, 0.3 and 0.1 (or as many as fit).
std::vector<std::size_t> draw_switch_points(std::size_t length, RandomStream& stream);

}  // namespace cambrian
