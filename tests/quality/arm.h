#pragma once

// Search methods that the benchmark compares; each changes the default settings in one respect.

#include "evolution/settings/experiment_settings.h"

#include <span>
#include <string_view>

namespace cambrian::quality {

// The goals of evolution. Most arms are run for the first one only.
inline constexpr const char* kGoals[] = {"walking", "swimming", "jumping"};

// Judged by the champion's score in held-out trials, and compared in a plan of its own.
inline constexpr const char* kSeeking = "seeking";

struct Arm {
    std::string_view id;
    std::string_view what;  // description
    void (*change)(ExperimentSettings& settings);
};

std::span<const Arm> all_arms();
const Arm& arm_of(std::string_view id);  // the id must be known

inline constexpr std::string_view kEvolution = "evolution";
inline constexpr std::string_view kRepeated = "evolution-again";
inline constexpr std::string_view kRandomSearch = "random-search";
inline constexpr std::string_view kBlind = "blind";
inline constexpr std::string_view kNoMutation = "no-mutation";
inline constexpr std::string_view kMapElites = "map-elites";
// Arms with a single breeding method have its id.
inline constexpr std::string_view kBreedingArms[] = {"asexual", "crossover", "grafting"};

}  // namespace cambrian::quality
