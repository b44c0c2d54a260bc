// Climbing, goals/README.md 9: the formula of walking, of the height of the ground where the
// trailing edge is. Only ground that was walked over counts, so neither a leap nor a tower scores.
#include "goals/goal.h"
#include "goals/mismatch.h"
#include "goals/steady_progress.h"

namespace cambrian {
namespace {

SteadyProgress rise_towards(const TrialRecord& record, int direction) {
    return progress_of(record, [&](std::size_t sample) {
        const MotionSample& at = record.samples[sample];
        return direction > 0 ? at.ground_low : at.ground_high;
    });
}

Score score_climbing(const TrialRecord& record) {
    const double time = scored_time(record);
    if (!(time > 0.0 && record.body_length > 0.0)) return {};
    const SteadyProgress right = rise_towards(record, 1);
    const SteadyProgress left = rise_towards(record, -1);
    const SteadyProgress& best = right.credit() >= left.credit() ? right : left;
    return {std::max(0.0, best.credit() / (record.body_length * time)),
            {{"height gained", best.all, "m"},
             {"slowest window", 4.0 * best.slowest / time, "m/s"},
             {"body length", record.body_length, "m"}}};
}

}  // namespace

void register_climbing(GoalRegistry& goals) {
    goals.add({.id = "climbing",
               .label = "Climbing",
               .unit = "BL/s",
               .help = "Steady gain of height over ground that rises, in body lengths per second; "
                       "leaps and towers count nothing.",
               .sample = "mountaineer",
               .default_confirmations = 2,
               .default_environment =
                   [] {
                       Environment environment;
                       environment.terrain = {.kind = "stairs", .height = 0.12, .spacing = 0.6};
                       return environment;
                   },
               .may_give_up = false,
               .mismatch = needs_shaped_ground,
               .score = score_climbing});
}

}  // namespace cambrian
