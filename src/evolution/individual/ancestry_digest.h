#pragma once

// A line of descent as one number: who was born when, of whom, by which method, with which genes,
// from the creature back through its mothers to the first of the line.

#include "evolution/individual/individual.h"

#include <cstdint>

namespace cambrian {

// The same however the line was stored and read again; another as soon as anything in it is.
std::uint64_t ancestry_digest(const Individual& individual);

}  // namespace cambrian
