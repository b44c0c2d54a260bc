#include "evolution/fields/setting_table.h"
#include "evolution/settings/goal_defaults.h"

#include <fmt/core.h>

namespace cambrian::setting_table {

void add_goal(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder goal(fields, "goal");
    goal.kind_choice(&Settings::goal, "behavior", "Behavior", kinds.goals.all(),
                     "The behavior that creatures are selected for.");
}

Status check_goal(const Settings& settings, const EvolutionKinds& kinds) {
    const GoalKind* goal = kinds.goals.find(settings.goal);
    if (goal == nullptr) return {};
    const std::string name = fmt::format("goal \"{}\"", goal->id);
    if (goal->is_contest && !settings.world.trial.has_cube)
        return Error{name + " has no cube to fight for: set [trial] cube = true"};
    if (goal->senses.empty()) return {};
    if (!settings.world.environment.has_light)
        return Error{name + " has no light: set [environment] light = true"};
    if (may_sense(settings, *goal)) return {};
    return Error{
        fmt::format("{} has a light but no creature may see it: set [body.sensors] {} = true", name,
                    goal->senses.front())};
}

}  // namespace cambrian::setting_table
