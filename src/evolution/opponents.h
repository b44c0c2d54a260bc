#pragma once

// The opponents of a contest (evolution/README.md 7).

#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <span>

namespace cambrian {

// The creatures that others contend with.
struct OpponentSource {
    std::span<const GenomePtr> champions;       // the best of each earlier generation, in order
    std::span<const IndividualPtr> population;  // not empty; only of use before the first champion
};

// Returns one opponent a trial: the best of the last generation, and then earlier champions drawn
// at random. In generation 0 they are drawn from the population.
Opponents draw_opponents(const OpponentSource& source, const ExperimentSettings& settings,
                         std::uint32_t generation);

}  // namespace cambrian
