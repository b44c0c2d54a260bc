#pragma once

// The runs of a comparison: every arm with every seed in every world.

#include "comparison/compared_run.h"
#include "core/result.h"
#include "persist/settings/settings_file.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cambrian {

// Settings with a name, which tables show.
struct NamedSettings {
    std::string name;
    // Settings texts in the order in which merge_settings() applies them.
    std::vector<SettingsText> texts;
};

struct ComparisonPlan {
    // The worlds in which arms are compared. If there are none, each arm's settings contain its
    // world, and all arms must have the same goal.
    std::vector<NamedSettings> worlds = {};
    // The arms that are compared. In a world, an arm needs only the settings that it changes. The
    // other arms are measured against the first one.
    std::vector<NamedSettings> arms = {};
    bool random_search = false;  // adds an arm like the first one that breeds random creatures only
    std::vector<std::uint64_t> seeds = {};
    int trials = 0;  // trials per run
    // Folder from which runs with [population] museum take founders; empty for none.
    std::filesystem::path museum = {};
};

inline constexpr const char* kRandomSearch = "random-search";

// Returns all runs, ordered so that a finished part of them is as balanced as possible. Fails for
// invalid settings, for equal names and for an arm that changes a world's goal or environment.
// Without worlds, it also fails for arms with different goals, and without a museum for runs that
// take founders from one.
Result<std::vector<PlannedRun>> planned_runs(const ComparisonPlan& plan,
                                             const EvolutionKinds& kinds);

}  // namespace cambrian
