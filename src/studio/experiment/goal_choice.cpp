#include "studio/experiment/goal_choice.h"

#include "evolution/settings/goal_defaults.h"
#include "studio/experiment/settings_editor.h"

namespace cambrian {

void change_goal(ExperimentSettings& settings, const GoalKind& before, const GoalKind& chosen,
                 const std::vector<SettingField>& fields) {
    ExperimentSettings old_defaults = settings;
    adopt_defaults(old_defaults, before);
    ExperimentSettings new_defaults = settings;
    for (const std::string& sense : before.distractions)
        new_defaults.founders.channels[sense] = true;
    adopt_defaults(new_defaults, chosen);
    if (settings.world.environment.dimensions == 3) {
        adopt_space(old_defaults.world);
        adopt_space(new_defaults.world);
    }
    settings.goal = chosen.id;
    for (const SettingField& field : fields) {
        if (same_value(field, settings, old_defaults)) copy_value(field, new_defaults, settings);
    }
    allow_senses(settings, chosen);
}

}  // namespace cambrian
