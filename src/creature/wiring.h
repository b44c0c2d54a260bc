#pragma once

// Resolves the source of every gene to a value slot and compiles the network (creature/README.md
// 5).

#include "creature/phenotype.h"

namespace cambrian {

// Adds network, sensors, effectors and organs to a phenotype whose parts have grown.
void wire(const Genome& genome, const Kinds& kinds, Phenotype& phenotype);

}  // namespace cambrian
