#include "evolution/fields/setting_field.h"

namespace cambrian {

std::vector<std::string> setting_warnings(const ExperimentSettings& settings,
                                          const EvolutionKinds& kinds) {
    std::vector<std::string> warnings;
    const GoalKind* goal = kinds.goals.find(settings.goal);
    if (goal != nullptr && goal->mismatch != nullptr) {
        const std::string mismatch = goal->mismatch(settings.world.environment);
        if (!mismatch.empty()) {
            warnings.push_back("[goal] behavior: " + goal->id +
                               " makes little sense in this [environment]: " + mismatch + ".");
        }
    }
    const TrialSettings& trial = settings.world.trial;
    if (trial.trials == 1 && (trial.friction_jitter > 0.0 || trial.tilt_jitter > 0.0))
        warnings.emplace_back("[trial] trials: jitter has no effect on the first trial of 1.");
    return warnings;
}

}  // namespace cambrian
