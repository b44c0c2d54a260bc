#pragma once

// A digest of a creature's line of descent: birth, parents, breeding method and genes of all, from
// the creature back through its mothers to the first one.

#include "evolution/individual/individual.h"

#include <cstdint>

namespace cambrian {

// The digest survives storing and loading; it changes if anything in the line changes.
std::uint64_t ancestry_digest(const Individual& individual);

}  // namespace cambrian
