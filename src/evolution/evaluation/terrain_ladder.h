#pragma once

// The ladder of difficulty of terrain (evolution/README.md 8).

#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>

namespace cambrian {

// Returns whether the settings have a ladder with a level above theirs.
bool climbs_ladder(const ExperimentSettings& settings);

// Returns the median of those that survived into a generation and have a score; null if none has.
IndividualPtr median_survivor(std::span<const IndividualPtr> population, std::uint32_t generation);

// Returns whether a creature keeps enough of the score that it has at the lowest level. Returns
// nothing if stopped.
std::optional<bool> is_ready_to_climb(const Individual& one, const ExperimentSettings& settings,
                                      EvaluationBackend& backend, const std::stop_token& stop);

SettingsPtr on_next_level(const ExperimentSettings& settings);

// Returns whether two settings of one run differ in what the run itself changes: the draw of
// chance, or the level of a ladder.
bool changed_by_run(const ExperimentSettings& before, const ExperimentSettings& after);

}  // namespace cambrian
