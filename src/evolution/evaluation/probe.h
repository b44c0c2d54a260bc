#pragma once

// A slightly changed world in which a creature is evaluated again, to reduce the influence of
// chance.

#include "evolution/settings/experiment_settings.h"
#include "genome/genome.h"

#include <cstdint>
#include <vector>

namespace cambrian {

struct Probe {
    std::uint64_t seed = 0;  // seed of the changes
    bool finer = false;      // uses half the contact step

    friend bool operator==(const Probe&, const Probe&) = default;
};

// Returns the probes of a generation, which are the same for all of its creatures. The first one
// has finer settings.
std::vector<Probe> probes_of(const ExperimentSettings& settings, std::uint32_t generation,
                             int count);

// Returns the settings of the probe's world. Gravity, friction and drag change by at most the share
// in the settings. The creature is turned by at most as many radians. The ground slopes by at most
// the angle in the settings. In space the creature faces any way.
ExperimentSettings probed_world(const Probe& probe, const ExperimentSettings& settings,
                                Genome& creature);

}  // namespace cambrian
