#pragma once

#include "genome/founders/random_gene.h"

namespace cambrian {

// Returns whether the settings enable all kinds of which rhythmic genomes consist: oscillators in
// parts, their constants, and joints that follow a neuron of their own part.
bool may_be_rhythmic(const GenePool& pool);

// Returns a random genome of limbs that move in one rhythm (genome/README.md 4). The limbs are
// chains of nodes from the root, single or in mirrored pairs. Each joint follows an oscillator of
// its part; all oscillators have one frequency and random phases. Requires may_be_rhythmic().
Genome rhythmic_genome(const GenePool& pool, RandomStream& stream);

}  // namespace cambrian
