#pragma once

#include "evolution/fields/setting_field.h"
#include "goals/goal.h"

#include <vector>

namespace cambrian {

// Adopts the defaults of a newly chosen goal (evolution/settings/goal_defaults.h) for every field
// that has the default of the goal before. Fields that differ from it were edited, and are kept. A
// sense that the new goal needs is switched on in any case.
void change_goal(ExperimentSettings& settings, const GoalKind& before, const GoalKind& chosen,
                 const std::vector<SettingField>& fields);

}  // namespace cambrian
