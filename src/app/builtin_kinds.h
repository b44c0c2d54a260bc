#pragma once

#include "evolution/kinds/evolution_kinds.h"

namespace cambrian {

// Every concrete kind of everything; the only place that names the physics.
EvolutionKinds builtin_kinds();

}  // namespace cambrian
