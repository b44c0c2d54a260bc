// Walking, goals/README.md 1. With e(t) the creature's trailing edge in a direction, t1 = 0.2 T,
// t2 = 0.6 T, d1 = e(t2) - e(t1), d2 = e(T) - e(t2):
//
//     S = max over both directions of [0.3 (d1 + d2) + 1.4 min(d1, d2)] / (BL * 0.8 T), at least 0
//
// For steady motion this is the speed in body lengths a second. The trailing edge, the ignored
// first fifth and the minimum of two halves keep falls, launches and single hops from paying.
#include "goals/goal.h"
#include "goals/mismatch.h"
#include "goals/sampling.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kStart = 0.2;  // shares of the trial
constexpr double kMiddle = 0.6;

// Progress of the edge that comes last, in metres towards +x (direction 1) or -x (direction -1).
double trailing_edge(const MotionSample& sample, int direction) {
    return direction > 0 ? sample.bounds.low.x() : -sample.bounds.high.x();
}

struct Halves {
    double first = 0.0;   // m
    double second = 0.0;  // m
    double credit() const { return 0.3 * (first + second) + 1.4 * std::min(first, second); }
};

Halves halves_towards(const TrialRecord& record, int direction) {
    const double start = trailing_edge(sample_at(record, kStart), direction);
    const double middle = trailing_edge(sample_at(record, kMiddle), direction);
    const double end = trailing_edge(sample_at(record, 1.0), direction);
    return {middle - start, end - middle};
}

Score score_walking(const TrialRecord& record) {
    const double scored_time = (1.0 - kStart) * record.duration;
    if (!(scored_time > 0.0 && record.body_length > 0.0)) return {};
    const Halves right = halves_towards(record, 1);
    const Halves left = halves_towards(record, -1);
    const Halves& best = right.credit() >= left.credit() ? right : left;
    const double speed = std::max(0.0, best.credit() / (record.body_length * scored_time));
    return {speed,
            {{"first half", best.first, "m"},
             {"second half", best.second, "m"},
             {"body length", record.body_length, "m"},
             {"speed", (best.first + best.second) / scored_time, "m/s"}}};
}

}  // namespace

void register_walking(GoalRegistry& goals) {
    goals.add({.id = "walking",
               .label = "Walking",
               .unit = "BL/s",
               .help = "Steady progress over the ground, in body lengths a second.",
               .default_environment = [] { return Environment{}; },
               .mismatch = needs_ground,
               .score = score_walking});
}

}  // namespace cambrian
