// Course, goals/README.md 10. The score is the number of obstacles that the trailing edge has left
// behind, at most ten, with the share of the way to the end of the next one's section:
//
//     S = d / (pad + 3 m) up to the end of the first, then 1 + (d - pad - 3 m) / 3 m
//
// where d is the way of the trailing edge from where it began. Ten obstacles passed at the time t
// are worth 0.5 (1 - t / T) more.
#include "goals/goal.h"
#include "goals/mismatch.h"
#include "goals/steady_progress.h"
#include "world/terrain_kinds.h"

namespace cambrian {
namespace {

constexpr double kObstacles = 10.0;
constexpr double kWorthOfTime = 0.5;  // obstacles

struct Passed {
    double obstacles = 0.0;
    double way = 0.0;   // m
    double time = 0.0;  // s, when that was reached
};

double obstacles_at(double edge, double start, double pad) {
    const double first = pad + kCourseSection;  // m, the end of its section
    if (edge < first) return std::max(0.0, (edge - start) / (first - start));
    return std::min(kObstacles, 1.0 + (edge - first) / kCourseSection);
}

// Returns the most obstacles passed at any sample.
Passed passed_towards(const TrialRecord& record, int direction) {
    Passed most;
    const double start = trailing_edge(record.samples.front(), direction);
    for (const MotionSample& sample : record.samples) {
        const double edge = trailing_edge(sample, direction);
        const double obstacles = obstacles_at(edge, start, record.level_ground);
        if (obstacles > most.obstacles) most = {obstacles, edge - start, sample.time};
    }
    return most;
}

Score score_course(const TrialRecord& record) {
    if (!(record.duration > 0.0) || record.samples.empty()) return {};
    const Passed right = passed_towards(record, 1);
    const Passed left = passed_towards(record, -1);
    const Passed& best = right.obstacles >= left.obstacles ? right : left;
    const double saved =
        best.obstacles >= kObstacles ? kWorthOfTime * (1.0 - best.time / record.duration) : 0.0;
    return {best.obstacles + saved,
            {{"distance", best.way, "m"},
             {"time", best.time, "s"},
             {"body length", record.body_length, "m"}}};
}

TrialSettings time_for_course() {
    TrialSettings trial;
    trial.duration = 30.0;
    trial.trials = 2;
    trial.renewal = 10;
    return trial;
}

}  // namespace

void register_course(GoalRegistry& goals) {
    goals.add({.id = "course",
               .label = "Obstacle courses",
               .unit = "obstacles",
               .help = "The number of obstacles left behind, of ten that are each harder than the "
                       "last, and up to half a one more for the time in which all are.",
               .sample = "hurdler",
               .default_environment =
                   [] {
                       Environment environment;
                       environment.terrain = {
                           .kind = "course", .height = 0.3, .gap = 0.6, .same = false};
                       return environment;
                   },
               .default_trial = time_for_course(),
               .may_give_up = false,
               .mismatch = needs_course,
               .score = score_course});
}

}  // namespace cambrian
