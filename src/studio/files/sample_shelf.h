#pragma once

// The creatures that come with the program, to open with one click.

#include "creature/phenotype.h"
#include "evolution/kinds/evolution_kinds.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

struct Sample {
    std::filesystem::path path;
    std::string title;    // "Walker"
    std::string account;  // "Walking, 2.31 m", or why it cannot be opened
    double hue = 0.0;
    std::shared_ptr<const Phenotype> phenotype;  // null if the file cannot be opened
};

struct SampleShelf {
    bool open = false;
    bool read = false;  // whether the folder was gone through
    std::vector<Sample> samples;
};

// Every creature file of a folder by title, those that cannot be opened last; none if there is no
// such folder.
std::vector<Sample> read_samples(const std::filesystem::path& folder, const EvolutionKinds& kinds);

}  // namespace cambrian
