#pragma once

// The output files of a run without a window.

#include "app/command_line/command_files.h"
#include "core/result.h"
#include "evolution/settings/experiment_settings.h"
#include "persist/creature/creature_file.h"

#include <filesystem>
#include <string>

namespace cambrian {

// An empty path means that the file is not written.
struct RunOutputs {
    std::filesystem::path champion;    // creature file
    std::filesystem::path experiment;  // experiment file, which does not exist yet
    bool numbered = false;             // the names are free ones of a folder
};

// All that the names of the files follow from.
struct OutputWish {
    const std::string& asked;
    const ExperimentSettings& settings;
    const CommandFiles& files;  // the command's other files
};

// Chooses the files. `asked` is an experiment file (*.cambrian), a creature file for the champion,
// or a folder for both (empty: the current folder; one that ends in '/' is created). Fails at once
// if nothing can be written there. In a folder it takes names that do not exist, with the same
// number for both, so that no file of an earlier run is replaced.
Result<RunOutputs> run_outputs(const OutputWish& wish);

// Saves the champion; returns its path. If another run has taken a name that was free, the next
// free one is used. A file that cannot be written is kept in a private folder, which the error
// names.
Result<std::filesystem::path> save_champion(const RunOutputs& outputs, const OutputWish& wish,
                                            const CreatureDocument& champion,
                                            const EvolutionKinds& kinds);

// Says which files a run will write.
std::string words_of(const RunOutputs& outputs);

}  // namespace cambrian
