#pragma once

// A hash of the body plan, which is the same for creatures that differ only in sizes.

#include "creature/phenotype.h"

#include <cstdint>

namespace cambrian {

// Hashes the tree of parts, the kinds of their joints, and which parts deform. Sizes, positions and
// order of the parts have no influence. Different trees have equal hashes with probability 2^-64.
std::uint64_t body_plan_hash(const Phenotype& phenotype);

}  // namespace cambrian
