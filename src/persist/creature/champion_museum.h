#pragma once

// A museum: a folder of creature files with the champions of many runs, of all goals and worlds, at
// most one of each body plan. Later runs take founders from it.

#include "persist/creature/creature_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kMuseumPlaces = 1000;

enum class Admission : std::uint8_t {
    kNew,          // the first with its body plan
    kInPlace,      // took the place of another with its plan, goal and world, and a lower score
    kKnown,        // there is one with its body plan already
    kNotEligible,  // it did not complete its trial, or its motion is suspect
    kFull,         // the museum has kMuseumPlaces creatures
};

std::string_view words_of(Admission admission);  // "the champion's body plan is new"

// Runs the scored trial of a champion again and puts it into the folder, which is made if it is
// missing. Fails if the trial gives another score, if it is stopped, or if files cannot be written.
Result<Admission> admit(const std::filesystem::path& museum, const CreatureDocument& champion,
                        const EvolutionKinds& kinds, const std::stop_token& stop = {});

// Draws as many creatures as the settings' share of the founders, by their seed and each at most
// once. Creatures of other dimensions and files that cannot be read are left out, so it may return
// less, or nothing if the folder is missing.
std::vector<GenomePtr> museum_founders(const std::filesystem::path& museum,
                                       const ExperimentSettings& settings,
                                       const EvolutionKinds& kinds);

// Says that settings take founders from a museum and none is named.
Error no_museum(const ExperimentSettings& settings);

}  // namespace cambrian
