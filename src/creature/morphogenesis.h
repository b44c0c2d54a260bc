#pragma once

// Grows a genome's parts breadth-first from the root (creature/README.md 1 to 4).

#include "creature/phenotype.h"

namespace cambrian {

// Adds the parts and body plan of a valid genome to the phenotype; wire() adds the neurons.
void grow(const Genome& genome, const Kinds& kinds, const ExpressionSettings& settings,
          const SceneSettings& scene, Side side, Phenotype& phenotype);

}  // namespace cambrian
