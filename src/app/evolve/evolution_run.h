#pragma once

// An unattended evolution: generation after generation with a report of each, kept in an experiment
// file, and the champion's file at the end. What `cambrian evolve` does, and `cambrian studio`
// where there is no display.

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
    std::string settings_file;           // empty to resume
    std::string resume;                  // experiment file to go on with
    std::vector<std::string> founders;   // creature files to begin with; empty: random creatures
    std::optional<int> generations;      // instead of the file's
    std::vector<std::uint64_t> seeds;    // a run with each, instead of the file's
    std::vector<std::string> sets;       // typed_setting(), over the file's
    std::optional<std::size_t> threads;  // one a core if absent; never changes a result
    ClusterLogin cluster;                // without servers: this machine alone
    std::string out;                     // see run_outputs(); empty to resume: no more files
    bool json = false;                   // a JSON object a line instead of words
};

// What it reads and writes.
CommandFiles files_of(const EvolutionRun& run);

// Says what goes wrong itself.
ExitStatus run_evolution(const EvolutionRun& run, const EvolutionKinds& kinds);

}  // namespace cambrian
