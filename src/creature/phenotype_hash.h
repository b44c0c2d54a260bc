#pragma once

// A hash of the phenotype, which is the same for creatures that differ only in unused genes.

#include "creature/phenotype.h"

#include <cstdint>

namespace cambrian {

// Hashes all that a trial can depend on: the body, the sensors, and the neurons that any effector
// reads, independent of their numbering. Genotypes that differ only in genes without effect, such
// as disconnected neurons, have the same hash. Different phenotypes have equal hashes with
// probability 2^-64. The hash depends on the settings of expression as far as they change the
// phenotype.
std::uint64_t phenotype_hash(const Phenotype& phenotype);

}  // namespace cambrian
