#include "evolution/settings/goal_defaults.h"

#include <algorithm>

namespace cambrian {

void adopt_defaults(ExperimentSettings& settings, const GoalKind& goal) {
    settings.world.environment = goal.default_environment();
    settings.world.trial = goal.default_trial;
    settings.selection.confirmations = goal.default_confirmations;
    allow_senses(settings, goal);
}

bool may_sense(const ExperimentSettings& settings, const GoalKind& goal) {
    const auto& channels = settings.founders.channels;
    return goal.senses.empty() ||
           std::any_of(goal.senses.begin(), goal.senses.end(), [&](const std::string& sense) {
               const auto set = channels.find(sense);
               return set != channels.end() && set->second;
           });
}

void allow_senses(ExperimentSettings& settings, const GoalKind& goal) {
    if (may_sense(settings, goal)) return;
    for (const std::string& sense : goal.senses)
        settings.founders.channels[sense] = true;
}

}  // namespace cambrian
