#include "app/trial/creature_world.h"

#include "core/text/counted.h"
#include "evolution/settings/goal_defaults.h"
#include "persist/settings/settings_file.h"

#include <fmt/core.h>

namespace cambrian {

Result<ExperimentSettings> world_of(const CreatureDocument& document,
                                    const std::string& environment, const EvolutionKinds& kinds) {
    if (!environment.empty()) return load_settings(environment, kinds);
    ExperimentSettings settings = document.settings();
    if (const GoalKind* goal = kinds.goals.find(settings.goal)) allow_senses(settings, *goal);
    return settings;
}

Status check_trial(const std::optional<int>& asked, const std::string& creature,
                   const ExperimentSettings& settings) {
    const int trials = settings.world.trial.trials;
    if (asked.value_or(1) <= trials) return {};
    return Error{fmt::format("{}: its score combines {}, so there is no trial {}", creature,
                             counted(static_cast<std::size_t>(trials), "trial"), *asked)};
}

}  // namespace cambrian
