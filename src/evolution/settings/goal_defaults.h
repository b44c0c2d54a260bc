#pragma once

#include "evolution/settings/experiment_settings.h"
#include "goals/goal.h"

#include <string_view>

namespace cambrian {

// The goal of settings in space that name none.
inline constexpr const char* kGoalOfSpace = "swimming";
// Whether a goal is built in space.
bool is_goal_of_space(std::string_view goal);

// Puts a world of the plane into space. A planar creature that is 1 m deep would move as before
// under the same numbers, and creatures in space have 1000 times the density.
void adopt_space(TrialWorld& world);
// Takes over the default goal of space and its world there.
void adopt_space_defaults(ExperimentSettings& settings, const GoalRegistry& goals);

// Takes over what suits a goal: environment, protocol of trials, their early
// termination, confirmations and senses.
void adopt_defaults(ExperimentSettings& settings, const GoalKind& goal);

// If the goal is impossible in the environment, takes over the first one that is possible there
// without particular senses or opponents, with the protocol of its trials. If there is none, the
// settings stay.
void adopt_possible_goal(ExperimentSettings& settings, const GoalRegistry& goals);

// Whether creatures may have one of the senses the goal needs, or it needs none.
bool may_sense(const ExperimentSettings& settings, const GoalKind& goal);
// Switches them on unless they may.
void allow_senses(ExperimentSettings& settings, const GoalKind& goal);

}  // namespace cambrian
