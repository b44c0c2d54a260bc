#include "app/trial/creature_world.h"

#include "evolution/settings/goal_defaults.h"
#include "persist/settings/settings_file.h"

namespace cambrian {

Result<ExperimentSettings> world_of(const CreatureDocument& document,
                                    const std::string& environment, const EvolutionKinds& kinds) {
    if (!environment.empty()) return load_settings(environment, kinds);
    ExperimentSettings settings = document.settings();
    if (const GoalKind* goal = kinds.goals.find(settings.goal)) allow_senses(settings, *goal);
    return settings;
}

}  // namespace cambrian
