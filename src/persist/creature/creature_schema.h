#pragma once

#include "evolution/kinds/evolution_kinds.h"

#include <string>

namespace cambrian {

// The rules of creature files as a JSON Schema (draft 2020-12), for editors and other programs;
// told by the description that reads and writes the files. It can express all errors but E01, E02,
// E09 and E13 (persist/README.md 2); of E10 it counts characters instead of bytes.
std::string creature_schema(const EvolutionKinds& kinds);

}  // namespace cambrian
