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
#include "goals/sampling.h"

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

// Ends of the windows, as shares of the trial.
constexpr std::array<double, 5> kSeams = {0.2, 0.4, 0.6, 0.8, 1.0};
constexpr double kWindows = 4.0;
constexpr double kShareOfAll = 0.3;  // weight of the total; the slowest window has the rest

// Returns the coordinate of the trailing edge, in m, in +x (direction 1) or -x (direction -1).
double trailing_edge(const MotionSample& sample, int direction) {
    return direction > 0 ? sample.bounds.low.x() : -sample.bounds.high.x();
}

struct Progress {
    double all = 0.0;      // m
    double slowest = 0.0;  // m, of the window with the least progress
    double credit() const { return kShareOfAll * all + (1.0 - kShareOfAll) * kWindows * slowest; }
};

// Returns the progress of an edge, whose coordinate at a sample's index is given.
template <class Edge>
Progress progress_of(const TrialRecord& record, Edge edge) {
    Progress progress;
    double before = edge(sample_index(record, kSeams.front()));
    for (std::size_t i = 1; i < kSeams.size(); ++i) {
        const double now = edge(sample_index(record, kSeams[i]));
        const double moved = now - before;
        progress.all += moved;
        progress.slowest = i == 1 ? moved : std::min(progress.slowest, moved);
        before = now;
    }
    return progress;
}

Progress progress_towards(const TrialRecord& record, int direction) {
    return progress_of(record, [&](std::size_t sample) {
        return trailing_edge(record.samples[sample], direction);
    });
}

Progress progress_along(const TrialRecord& record, std::size_t heading) {
    const std::size_t back = (heading + kHeadings / 2) % kHeadings;
    return progress_of(record, [&](std::size_t sample) { return -record.supports[sample][back]; });
}

Progress best_progress_in_space(const TrialRecord& record) {
    if (record.up.x() != 0.0)
        return progress_along(record, record.up.x() > 0.0 ? 0 : kHeadings / 2);
    Progress best = progress_along(record, 0);
    for (std::size_t heading = 1; heading < kHeadings; ++heading) {
        const Progress progress = progress_along(record, heading);
        if (progress.credit() > best.credit()) best = progress;
    }
    return best;
}

Progress best_progress(const TrialRecord& record) {
    if (record.dimensions == 3) return best_progress_in_space(record);
    if (record.up.x() > 0.0) return progress_towards(record, 1);
    if (record.up.x() < 0.0) return progress_towards(record, -1);
    const Progress right = progress_towards(record, 1);
    const Progress left = progress_towards(record, -1);
    return right.credit() >= left.credit() ? right : left;
}

Score score_walking(const TrialRecord& record) {
    const double scored_time = (1.0 - kSeams.front()) * record.duration;
    if (!(scored_time > 0.0 && record.body_length > 0.0)) return {};
    const Progress best = best_progress(record);
    const double speed = std::max(0.0, best.credit() / (record.body_length * scored_time));
    return {speed,
            {{"distance", best.all, "m"},
             {"slowest window", best.slowest * kWindows / scored_time, "m/s"},
             {"body length", record.body_length, "m"},
             {"speed", best.all / scored_time, "m/s"}}};
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
