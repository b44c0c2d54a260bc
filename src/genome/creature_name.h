#pragma once

// The names of creatures.

#include "genome/genome.h"

#include <cstdint>
#include <string>

namespace cambrian {

// Returns a name of three syllables for a genome_hash(), "Tavinor": the same on every machine, and
// the same for creatures with the same genes. There are 168 150 names; among 300 different
// creatures, two share one about every fourth time. The syllables are chosen such that they do not
// join to an offensive word of the larger European languages.
std::string coined_name(std::uint64_t genome_hash);

// Returns the name that the genome was given, on one line, or else its coined name.
std::string creature_name(const Genome& genome);

}  // namespace cambrian
