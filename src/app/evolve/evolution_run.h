#pragma once

// Evolution without a window: evaluates and reports generation after generation, saves them in an
// experiment file, and saves the champion at the end. `cambrian evolve` uses it, and `cambrian
// studio` if there is no display.

#include "app/command_line/command_files.h"
#include "app/process/exit_status.h"
#include "cluster/connection/cluster_address.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

struct EvolutionRun {
    std::string settings_file;  // empty if `resume` is set
    std::string resume;         // experiment file to continue
    // Creature files of the founders; empty for random creatures.
    std::vector<std::string> founders;
    std::string museum;  // folder that gives founders and takes the champion; empty for none
    std::optional<int> generations;    // overrides the file's
    std::vector<std::uint64_t> seeds;  // one run for each; overrides the file's
    std::vector<std::string> sets;     // see typed_setting(); override the file's
    // Creature files that join the next generation of an experiment that is continued.
    std::vector<std::string> injected;
    std::optional<std::size_t> threads;  // one per core if absent; does not change results
    ClusterLogin cluster;                // without servers, only this machine evaluates
    std::string out;    // see run_outputs(); empty with `resume`: writes no further files
    bool json = false;  // writes one JSON object per line instead of text
};

// Returns the files that the run reads and writes.
CommandFiles files_of(const EvolutionRun& run);

// Runs the evolution and prints its own error messages.
ExitStatus run_evolution(const EvolutionRun& run, const EvolutionKinds& kinds);

}  // namespace cambrian
