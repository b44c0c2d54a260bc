#include "evolution/fields/setting_table.h"
#include "evolution/settings/goal_defaults.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian::setting_table {
namespace {

bool is_of_light(const std::string& channel, const SensorRegistry& sensors) {
    const auto has_channel = [&](const SensorKind& kind) {
        return std::any_of(kind.channels.begin(), kind.channels.end(),
                           [&](const SensorChannel& each) { return each.id == channel; });
    };
    const auto kind = std::find_if(sensors.all().begin(), sensors.all().end(), has_channel);
    return kind != sensors.all().end() && kind->sees;
}

}  // namespace

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
    const bool by_light = is_of_light(goal->senses.front(), kinds.creature.sensors);
    const Environment& world = settings.world.environment;
    if (by_light && !world.has_light)
        return Error{name + " has no light: set [environment] light = true"};
    if (!by_light && !world.has_wall)
        return Error{name + " has no wall: set [environment] wall = true"};
    if (may_sense(settings, *goal)) return {};
    return Error{fmt::format("{} has a {} but no creature may {} it: set [body.sensors] {} = true",
                             name, by_light ? "light" : "wall", by_light ? "see" : "sense",
                             goal->senses.front())};
}

}  // namespace cambrian::setting_table
