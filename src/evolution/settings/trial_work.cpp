#include "evolution/settings/trial_work.h"

#include "core/text/counted.h"
#include "core/text/number_text.h"

#include <fmt/core.h>

#include <cmath>

namespace cambrian {
namespace {

double simulated_time(const TrialSettings& trial) {
    return trial.trials * (trial.duration + trial.settle_limit);
}

}  // namespace

double most_evaluations(const TrialSettings& trial) {
    return std::floor(kMostTrialWork / simulated_time(trial));
}

std::optional<std::string> trial_excess(const TrialWorld& world) {
    const TrialSettings& trial = world.trial;
    const std::string trials =
        fmt::format("{} of {} s", counted(static_cast<std::size_t>(trial.trials), "trial"),
                    short_text(trial.duration));
    const double time = trial.trials * trial.duration;
    if (!(time <= kMostTrialTime))
        return fmt::format("{}, {} s in all; limit {} s", trials, short_text(time),
                           short_text(kMostTrialTime));
    const double work = simulated_time(trial) * world.scene.max_evaluations;
    if (!(work <= kMostTrialWork))
        return fmt::format("{} and {} s of settling, at up to {} evaluations/s {} in all; limit {}",
                           trials, short_text(trial.settle_limit),
                           short_text(world.scene.max_evaluations), short_text(work),
                           short_text(kMostTrialWork));
    return std::nullopt;
}

}  // namespace cambrian
