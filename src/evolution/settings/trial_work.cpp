#include "evolution/settings/trial_work.h"

#include "core/text/number_text.h"

namespace cambrian {

std::optional<std::string> trial_excess(const TrialWorld& world) {
    const TrialSettings& trial = world.trial;
    const std::string trials = std::to_string(trial.trials) +
                               (trial.trials == 1 ? " trial of " : " trials of ") +
                               short_text(trial.duration) + " s";
    const double time = trial.trials * trial.duration;
    if (!(time <= kMostTrialTime))
        return trials + ", " + short_text(time) + " s in all; limit " + short_text(kMostTrialTime) +
               " s";
    const double work =
        trial.trials * (trial.duration + trial.settle_limit) * world.scene.max_evaluations;
    if (!(work <= kMostTrialWork))
        return trials + " and " + short_text(trial.settle_limit) + " s of settling, at up to " +
               short_text(world.scene.max_evaluations) + " evaluations/s " + short_text(work) +
               " in all; limit " + short_text(kMostTrialWork);
    return std::nullopt;
}

}  // namespace cambrian
