#pragma once

#include "evolution/evolution_kinds.h"

namespace cambrian {

// Every concrete kind of this program, from every layer; the only place that names them all.
EvolutionKinds builtin_kinds();

}  // namespace cambrian
