#pragma once

// Which creatures are built alike, whatever their sizes.

#include "creature/phenotype.h"

#include <cstdint>

namespace cambrian {

// Over the tree of parts and the kinds of their joints, whatever the parts' sizes, places and
// order. Different trees have the same with probability 2^-64.
std::uint64_t body_plan_hash(const Phenotype& phenotype);

}  // namespace cambrian
