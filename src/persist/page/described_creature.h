#pragma once

// What a page must know of a creature to draw it, besides its motion.

#include "persist/creature/creature_file.h"

#include <string>

namespace cambrian {

// Returns the parts at rest and the world of the creature's trial, as an object of JSON that
// assets/page/body.js and page.js read.
std::string described_creature(const CreatureDocument& document, const Phenotype& phenotype,
                               const EvolutionKinds& kinds);

}  // namespace cambrian
