#pragma once

// Challenge files, *.challenge.toml: settings files with a table [challenge], whose goal, world,
// seed and number of trials are frozen, so that the creatures of several people can be compared.
// Whatever reads settings reads them. Any text is safe to read.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr std::string_view kChallengeEnding = ".challenge.toml";
inline constexpr std::size_t kLongestChallengeName = 80;  // bytes
inline constexpr std::int64_t kMostChallengeSeed = 1'000'000'000'000'000;

// What the table [challenge] says.
struct ChallengeTable {
    std::string name;
    std::uint64_t held_out_seed = 0;  // of the chance in the trials that rank entries
    std::string simulator;            // version

    friend bool operator==(const ChallengeTable&, const ChallengeTable&) = default;
};

struct Challenge {
    ChallengeTable table;
    ExperimentSettings settings;  // max_evaluations is the number of trials

    friend bool operator==(const Challenge&, const Challenge&) = default;
};

// Freezes settings: the seed and the number of trials end the search, and nothing else does.
Challenge make_challenge(ExperimentSettings settings, ChallengeTable table, int trials);

// Fails if the text is no challenge.
Result<Challenge> parse_challenge(std::string_view text, std::string_view source,
                                  const EvolutionKinds& kinds);
Result<Challenge> load_challenge(const std::filesystem::path& path, const EvolutionKinds& kinds);
std::string write_challenge(const Challenge& challenge, const EvolutionKinds& kinds);

}  // namespace cambrian
