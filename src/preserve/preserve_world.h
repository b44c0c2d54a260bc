#pragma once

// The state that all parts of a preserve share: settings, place, energy and the record of what
// happens.

#include "core/random.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "evolution/settings/light_patches.h"
#include "preserve/chronicle.h"
#include "preserve/series.h"
#include "preserve/world/common_senses.h"
#include "preserve/world/drawn_walls.h"
#include "preserve/world/ledger.h"

#include <vector>

namespace cambrian {

// Uses of random streams, which are numbered by tick or by attempt.
enum class PreserveUse : std::uint64_t { kGrowth, kBirth, kArrival, kSowing };

struct PreserveWorld {
    // Settings must have passed check_preserve().
    PreserveWorld(SettingsPtr founding, const EvolutionKinds& all_kinds);

    std::uint64_t seed(std::uint64_t index, PreserveUse use) const;
    RandomStream stream(std::uint64_t index, PreserveUse use) const {
        return RandomStream(seed(index, use));
    }
    // The environment of the creatures under the laws of the moment.
    Environment environment() const { return world_environment(*laws); }
    // Turns half of the light into plants, so that founders do not starve before any grow.
    void sow();
    // Turns light into plants, and flesh into light.
    void grow_plants();

    SettingsPtr settings;  // with which it began; residents refer to them
    SettingsPtr laws;      // the same with all changes so far
    const EvolutionKinds& kinds;
    WorldArea area;
    CommonSenses senses;
    DrawnWalls walls;
    std::vector<LightPatch> patches;
    Ledger energy;
    std::uint64_t tick = 0;
    Tally tally;
    Chronicle chronicle;
};

}  // namespace cambrian
