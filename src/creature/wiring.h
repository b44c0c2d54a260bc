#pragma once

// Resolves every gene's source to a value slot and compiles the network (creature/README.md 5).

#include "creature/phenotype.h"

namespace cambrian {

// Adds network, sensors and effectors to grown parts.
void wire(const Genome& genome, const Kinds& kinds, Phenotype& phenotype);

}  // namespace cambrian
