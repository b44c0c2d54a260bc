#pragma once

#include "evolution/kinds/evolution_kinds.h"

namespace cambrian {

// Returns all built-in kinds. Only this function names the implementation of physics.
EvolutionKinds builtin_kinds();

}  // namespace cambrian
