#pragma once

#include "creature/phenotype.h"

#include <cstddef>

namespace cambrian {

// The organs and senses of a creature that need something of its surroundings.
struct UsedSenses {
    bool scents = false;        // has an organ that gives off scent
    bool smells = false;        // has a sense of smell that something reads
    bool feels_ground = false;  // has a whisker or a sense of the ground's height
    std::size_t voices = 0;     // largest number of sounds that its organs make in a tick
};

UsedSenses senses_of(const Phenotype& phenotype, const Kinds& kinds);

}  // namespace cambrian
