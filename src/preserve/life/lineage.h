#pragma once

// Lineages: a newborn founds one if its body has become another one (preserve/README.md 6).

#include "genome/genome.h"

namespace cambrian {

// Returns the number of genes of parts and of their edges in which two bodies differ. A part that
// only one has counts as all its genes.
int differing_body_genes(const Genome& a, const Genome& b);

inline constexpr int kGenesOfALineage = 4;  // that may differ from the founder's

}  // namespace cambrian
