#pragma once

#include "evolution/kinds/evolution_kinds.h"

namespace cambrian {

// Returns all built-in kinds of worlds in two or three dimensions. Only this function names the
// implementations of physics.
EvolutionKinds builtin_kinds(int dimensions = 2);

}  // namespace cambrian
