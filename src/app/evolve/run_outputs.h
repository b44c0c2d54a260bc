#pragma once

// What an unattended run leaves behind, and where.

#include "app/command_line/command_files.h"
#include "core/result.h"
#include "evolution/settings/experiment_settings.h"

#include <filesystem>
#include <string>

namespace cambrian {

// Empty paths: not kept.
struct RunOutputs {
    std::filesystem::path champion;    // creature file
    std::filesystem::path experiment;  // experiment file, not there yet
};

// asked: an experiment file (*.cambrian), a folder for one and for the champion (empty: the
// current folder; one that ends in '/' is made), or else the champion's file. Fails at once if
// nothing can be written there. In a folder names are taken that are free, the same number for
// both: nothing of an earlier run is replaced. `files`: of the command.
Result<RunOutputs> run_outputs(const std::string& asked, const ExperimentSettings& settings,
                               const CommandFiles& files);

}  // namespace cambrian
