#pragma once

// Which creatures are the same although their genes differ.

#include "creature/phenotype.h"

#include <cstdint>

namespace cambrian {

// Over all that a trial can depend on: the body, what it senses, and the neurons that any effector
// hears, however they are numbered. Genotypes that differ only in genes that come to nothing (mute
// neurons, say) have the same; different phenotypes have the same with probability 2^-64. Depends
// on the settings the phenotype was expressed under where these show in it.
std::uint64_t phenotype_hash(const Phenotype& phenotype);

}  // namespace cambrian
