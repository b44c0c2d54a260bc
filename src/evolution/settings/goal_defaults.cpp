#include "evolution/settings/goal_defaults.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kSettleLimitInSpace = 4.0;  // s; bodies fall over to more sides

}  // namespace

void adopt_defaults(ExperimentSettings& settings, const GoalKind& goal) {
    settings.world.environment = goal.default_environment();
    settings.world.trial = goal.default_trial;
    settings.selection.confirmations = goal.default_confirmations;
    settings.terminate_early = goal.default_give_up;
    for (const std::string& sense : goal.distractions)
        settings.founders.channels[sense] = false;
    allow_senses(settings, goal);
}

bool is_goal_of_space(std::string_view goal) {
    return goal == "walking" || goal == "jumping" || goal == kGoalOfSpace;
}

void adopt_space(TrialWorld& world) {
    constexpr double scale = 1000.0;  // kg/m^3 of a body that is as heavy as water
    Environment& environment = world.environment;
    environment.dimensions = 3;
    environment.terrain = {};
    environment.density *= scale;
    environment.viscosity_linear *= scale;
    environment.viscosity_quadratic *= scale;
    world.scene.muscle_strength *= scale;
    if (environment.has_ground) world.trial.settle_limit = kSettleLimitInSpace;
}

void adopt_space_defaults(ExperimentSettings& settings, const GoalRegistry& goals) {
    settings.goal = kGoalOfSpace;
    if (const GoalKind* goal = goals.find(settings.goal)) adopt_defaults(settings, *goal);
    adopt_space(settings.world);
}

void adopt_possible_goal(ExperimentSettings& settings, const GoalRegistry& goals) {
    const auto is_possible = [&settings](const GoalKind& goal) {
        return mismatch_of(goal, settings.world.environment).empty();
    };
    const GoalKind* present = goals.find(settings.goal);
    if (present != nullptr && is_possible(*present)) return;
    for (const GoalKind& goal : goals.all()) {
        if (!is_possible(goal) || !goal.senses.empty() || goal.is_contest) continue;
        settings.goal = goal.id;
        settings.world.trial = goal.default_trial;
        return;
    }
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
