#pragma once

// A slightly changed world, in which a creature is evaluated again to tell merit from luck.

#include "evolution/settings/experiment_settings.h"
#include "genome/genome.h"

#include <cstdint>
#include <vector>

namespace cambrian {

struct Probe {
    std::uint64_t seed = 0;  // of what differs
    bool finer = false;      // computed with half the contact step

    friend bool operator==(const Probe&, const Probe&) = default;
};

// The worlds of a generation, the same for all of its creatures. The first one has finer settings.
std::vector<Probe> probes_of(const ExperimentSettings& settings, std::uint32_t generation,
                             int count);

// The settings with gravity, friction and drag of the probe's world, each changed by at most the
// settings' share. The creature is turned by at most as many radians.
ExperimentSettings probed_world(const Probe& probe, const ExperimentSettings& settings,
                                Genome& creature);

}  // namespace cambrian
