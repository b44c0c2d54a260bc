#pragma once

#include "evolution/kinds/evolution_kinds.h"

#include <string>

namespace cambrian {

// Returns the rules of creature files as a JSON Schema (draft 2020-12), for editors and other
// programs. The description that reads and writes the files generates it. It can express all errors
// except E01, E02, E09 and E13 (persist/README.md 2); for E10 it counts characters instead of
// bytes.
std::string creature_schema(const EvolutionKinds& kinds);

}  // namespace cambrian
