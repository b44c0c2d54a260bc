// Walking, goals/README.md 1. p1..p4 is the progress of the creature's trailing edge in a direction
// in the windows [.2,.4] [.4,.6] [.6,.8] [.8,1] T:
//
//     S = max over both directions of [0.3 (p1 + p2 + p3 + p4) + 2.8 min(p)] / (BL * 0.8 T),
//
// at least 0. In space there are 16 directions. On a slope only the direction uphill counts, since
// gravity carries a body down. For steady motion this is the speed in body lengths per second. The
// trailing edge,
// the ignored first fifth and the minimum of four windows prevent falls, launches and single hops
// from scoring: a single event moves the edge in at most two windows.
#include "goals/goal.h"
#include "goals/mismatch.h"
#include "goals/steady_progress.h"

namespace cambrian {
namespace {

SteadyProgress progress_along(const TrialRecord& record, std::size_t heading) {
    const std::size_t back = (heading + kHeadings / 2) % kHeadings;
    return progress_of(record, [&](std::size_t sample) { return -record.supports[sample][back]; });
}

SteadyProgress best_progress_in_space(const TrialRecord& record) {
    if (record.up.x() != 0.0)
        return progress_along(record, record.up.x() > 0.0 ? 0 : kHeadings / 2);
    SteadyProgress best = progress_along(record, 0);
    for (std::size_t heading = 1; heading < kHeadings; ++heading) {
        const SteadyProgress progress = progress_along(record, heading);
        if (progress.credit() > best.credit()) best = progress;
    }
    return best;
}

SteadyProgress best_progress(const TrialRecord& record) {
    if (record.dimensions == 3) return best_progress_in_space(record);
    if (record.up.x() > 0.0) return progress_towards(record, 1);
    if (record.up.x() < 0.0) return progress_towards(record, -1);
    const SteadyProgress right = progress_towards(record, 1);
    const SteadyProgress left = progress_towards(record, -1);
    return right.credit() >= left.credit() ? right : left;
}

Score score_walking(const TrialRecord& record) {
    const double time = scored_time(record);
    if (!(time > 0.0 && record.body_length > 0.0)) return {};
    const SteadyProgress best = best_progress(record);
    const double speed = std::max(0.0, best.credit() / (record.body_length * time));
    return {speed,
            {{"distance", best.all, "m"},
             {"slowest window", 4.0 * best.slowest / time, "m/s"},
             {"body length", record.body_length, "m"},
             {"speed", best.all / time, "m/s"}}};
}

}  // namespace

void register_walking(GoalRegistry& goals) {
    goals.add({.id = "walking",
               .label = "Walking",
               .unit = "BL/s",
               .help = "Steady progress over the ground, in body lengths per second; uphill if the "
                       "ground slopes.",
               .sample = "walker",
               .default_confirmations = 2,
               .default_environment = [] { return Environment{}; },
               .default_give_up = true,
               .mismatch = needs_ground,
               .score = score_walking});
}

}  // namespace cambrian
