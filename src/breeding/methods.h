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

// What every child starts as: the first parent without its name.
Genome child_of(const Genome& parent);

// Crossover of parents whose nodes are aligned by position, breeding/README.md 7.
Genome cross(const Genome& first, const Genome& second, const KindCatalog& catalog,
             RandomStream& stream);

// Where crossover changes parents while copying `length` nodes: one, two or three different places
// in 1 .. length-1 with probability .6, .3, .1 (fewer where they do not fit), ascending.
std::vector<std::size_t> draw_switch_points(std::size_t length, RandomStream& stream);

}  // namespace cambrian
