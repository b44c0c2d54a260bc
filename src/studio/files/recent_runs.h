#pragma once

// The runs that the user opened or saved lately, for the start page.

#include "creature/phenotype.h"
#include "evolution/kinds/evolution_kinds.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kMostRecent = 12;

struct RecentRun {
    std::filesystem::path path;
    std::string title;      // "my-walkers"
    std::string account;    // "Walking, 1.05 BL/s, 120 generations", or why it cannot be opened
    bool readable = false;  // whether it can be opened
    double hue = 0.0;
    std::uint64_t line = 0;
    std::shared_ptr<const Phenotype> champion;  // null if there is none to show
};

struct StartPage {
    bool open = false;
    bool read = false;                         // whether `runs` is what the files hold
    std::vector<std::filesystem::path> paths;  // of the runs, the last used one first
    std::vector<RecentRun> runs;
    std::vector<std::filesystem::path> challenges;  // that come with the program, sorted
};

// Returns the challenges of a folder, sorted; none if it cannot be read.
std::vector<std::filesystem::path> challenges_in(const std::filesystem::path& folder);

// Puts a run first among others of which there are at most kMostRecent.
void use_run(std::vector<std::filesystem::path>& paths, const std::filesystem::path& path);

// Reads what a file says of its run: its goal, its generations and its newest champion. The file
// does not change, and may be open elsewhere.
RecentRun read_run(const std::filesystem::path& path, const EvolutionKinds& kinds);

}  // namespace cambrian
