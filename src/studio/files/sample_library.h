#pragma once

// The sample creatures that come with the program, and those of the user's museum.

#include "creature/phenotype.h"
#include "evolution/individual/judged_individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "studio/hand_picking/grid_motion.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

struct Sample {
    std::filesystem::path path;
    std::string title;    // "Walker"
    std::string account;  // "Walking, 2.31 m", or why the file cannot be opened
    double hue = 0.0;
    std::shared_ptr<const Phenotype> phenotype;  // null if the file cannot be opened
    JudgedIndividual creature = {};              // with the settings of its file; the same
    const EvolutionKinds* kinds = nullptr;       // of its world; the same
    bool of_museum = false;                      // rather than of the program
};

struct SampleLibrary {
    bool open = false;
    bool read = false;  // whether the folder was read
    std::vector<Sample> samples;
    // The one that is watched, and its motion; empty and null if none is.
    std::filesystem::path watched;
    const GridMotion* motion = nullptr;
};

// Returns the creatures of a folder sorted by title, those that cannot be opened last. The result
// is empty if the folder does not exist. Those of a world with other dimensions than that of
// `kinds` need `elsewhere`.
std::vector<Sample> read_samples(const std::filesystem::path& folder, const EvolutionKinds& kinds,
                                 const EvolutionKinds* elsewhere = nullptr);
// Returns those of several folders, and last those of the museum (champion_museum.h), if its path
// is not empty. Of both, those that can take part in the world of `kinds` come first.
std::vector<Sample> read_sample_folders(const std::vector<std::filesystem::path>& folders,
                                        const std::filesystem::path& museum,
                                        const EvolutionKinds& kinds,
                                        const EvolutionKinds* elsewhere);

}  // namespace cambrian
