#pragma once

// Which runs make up a comparison: arms x seeds in every world.

#include "comparison/compared_run.h"
#include "core/result.h"
#include "persist/settings/settings_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

// Settings with the name that tables show.
struct NamedSettings {
    std::string name;
    std::vector<SettingsText> texts;  // merge_settings()
};

struct ComparisonPlan {
    // What arms are compared in. None: each arm says its world itself, and all say the same goal.
    std::vector<NamedSettings> worlds = {};
    // What is compared; in a world, an arm says only what it changes there. The first is what the
    // others are measured against.
    std::vector<NamedSettings> arms = {};
    bool random_search = false;  // one more arm: the first one's with new random creatures only
    std::vector<std::uint64_t> seeds = {};
    int trials = 0;  // of each run
};

inline constexpr const char* kRandomSearch = "random-search";

// All runs, ordered so that what is known after a part of them is as balanced as can be. Fails for
// settings that are wrong, for two of a name, for an arm that changes a world's goal or environment
// and, without worlds, for arms of several goals.
Result<std::vector<PlannedRun>> planned_runs(const ComparisonPlan& plan,
                                             const EvolutionKinds& kinds);

}  // namespace cambrian
