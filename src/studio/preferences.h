#pragma once

// The state that the studio keeps between two runs of the program: its arrangement, the edited
// settings and the open experiment.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "studio/look/view_state.h"
#include "studio/machines/cluster_memory.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

struct Preferences {
    ViewState view;
    ExperimentSettings settings;
    std::string experiment;  // file of the open experiment; empty for the folder's own
    ClusterMemory cluster;
    // Tells the user what became of settings that could not be read; empty if they could.
    std::string fault = {};
    std::vector<std::filesystem::path> recent = {};  // runs used lately, the last one first

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

// Reads the state from a folder; missing or damaged parts have their defaults. A settings file that
// cannot be read gets another name, so that it is not overwritten.
Preferences recall(const std::filesystem::path& folder, const EvolutionKinds& kinds);
// Returns in how many dimensions the settings in a folder live; 2 where there are none.
int remembered_dimensions(const std::filesystem::path& folder);
// Writes the state to a folder, which it creates if necessary.
Status remember(const std::filesystem::path& folder, const Preferences& remembered,
                const EvolutionKinds& kinds);

// Returns the path in a folder of the experiment that has no file of its own.
std::filesystem::path own_experiment(const std::filesystem::path& folder);

// Returns the path in a folder of the champions of earlier runs; empty if the folder is.
std::filesystem::path own_museum(const std::filesystem::path& folder);

// The arrangement as text, one "name = value" on each line. Unknown lines are ignored.
std::string write_view(const ViewState& view);
ViewState parse_view(std::string_view text);
// The cluster in the same format; values may contain spaces.
std::string write_cluster(const ClusterMemory& cluster);
ClusterMemory parse_cluster(std::string_view text);

}  // namespace cambrian
