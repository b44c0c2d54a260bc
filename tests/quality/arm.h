#pragma once

// Ways of searching that the benchmark compares; each changes the usual settings in one respect.

#include "evolution/settings/experiment_settings.h"

#include <span>
#include <string_view>

namespace cambrian::quality {

// What is evolved for; most arms are run for the first alone.
inline constexpr const char* kGoals[] = {"walking", "swimming", "jumping"};

struct Arm {
    std::string_view id;
    std::string_view what;  // for a person
    void (*change)(ExperimentSettings& settings);
};

std::span<const Arm> all_arms();
const Arm& arm_of(std::string_view id);  // of a known id

inline constexpr std::string_view kEvolution = "evolution";
inline constexpr std::string_view kRepeated = "evolution-again";
inline constexpr std::string_view kRandomSearch = "random-search";
inline constexpr std::string_view kNoMutation = "no-mutation";
inline constexpr std::string_view kMapElites = "map-elites";
// Arms of a single breeding method have its id.
inline constexpr std::string_view kBreedingArms[] = {"asexual", "crossover", "grafting"};

}  // namespace cambrian::quality
