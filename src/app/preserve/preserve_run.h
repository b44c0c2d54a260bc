#pragma once

// The command `preserve`: a preserve without a window.

#include "app/command_line/command_files.h"
#include "app/process/exit_status.h"
#include "evolution/kinds/evolution_kinds.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

struct PreserveRun {
    std::string settings_file;
    std::vector<std::string> founders;
    std::optional<std::uint64_t> seed;
    std::optional<double> seconds;  // of its time at which it ends; none for no end
    std::optional<int> threads;
    std::string out;
    std::string resume;
    std::vector<std::string> laws;  // changes, as "preserve.growth-time=60"
    bool json = false;
};

CommandFiles files_of(const PreserveRun& run);
ExitStatus run_preserve(const PreserveRun& run, const EvolutionKinds& kinds);

}  // namespace cambrian
