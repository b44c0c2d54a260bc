#include "evolution/fields/setting_field.h"

#include <fmt/core.h>

namespace cambrian {

std::vector<std::string> setting_warnings(const ExperimentSettings& settings,
                                          const EvolutionKinds& kinds) {
    std::vector<std::string> warnings;
    const GoalKind* goal = kinds.goals.find(settings.goal);
    if (goal != nullptr) {
        const std::string mismatch = mismatch_of(*goal, settings.world.environment);
        if (!mismatch.empty()) {
            warnings.push_back(
                fmt::format("[goal] behavior: {} makes little sense in this [environment]: {}.",
                            goal->id, mismatch));
        }
    }
    const TerrainSettings& terrain = settings.world.environment.terrain;
    if (!terrain.points.empty() && terrain.kind != "drawn")
        warnings.push_back(
            fmt::format("[environment] terrain-points: they have no effect while "
                        "terrain is \"{}\".",
                        terrain.kind));
    const TrialSettings& trial = settings.world.trial;
    if (trial.trials == 1 && (trial.friction_jitter > 0.0 || trial.tilt_jitter > 0.0))
        warnings.emplace_back("[trial] trials: jitter has no effect on the first trial of 1.");
    if (goal != nullptr && goal->shares != nullptr && trial.trials % 2 == 1)
        warnings.push_back(
            fmt::format("[trial] trials: {} leaves one without its mirror image, so a habit of "
                        "turning one way may pay.",
                        trial.trials));
    return warnings;
}

}  // namespace cambrian
