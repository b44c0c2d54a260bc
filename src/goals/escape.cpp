// Escape, goals/README.md 7. A wall that nobody can cross stands on one side, 3 to 5 m away. Only
// progress away from it counts, by the formula of walking:
//
//     s = max(0, 0.3 (p1 + p2 + p3 + p4) + 2.8 min(p)) / (BL * 0.8 T)
//
// Half of the trials have the wall on the left. The score is 0.1 mean(s) + 0.9 mean(worse half of
// s), so a creature must walk either way and know which: no body can feel the wall in time.
#include "goals/goal.h"
#include "goals/mismatch.h"
#include "goals/steady_progress.h"

namespace cambrian {
namespace {

constexpr int kPairsOfTrials = 2;  // both sides, at two distances
constexpr int kWallRenewal = 5;    // generations

Score score_escape(const TrialRecord& record) {
    const double time = scored_time(record);
    if (!(time > 0.0 && record.body_length > 0.0) || record.wall_side == 0) return {};
    const SteadyProgress away = progress_towards(record, -record.wall_side);
    return {std::max(0.0, away.credit() / (record.body_length * time)),
            {{"distance from the wall", away.all, "m"},
             {"body length", record.body_length, "m"},
             {"speed", away.all / time, "m/s"}}};
}

TrialSettings balanced_sides() {
    TrialSettings trial;
    trial.trials = 2 * kPairsOfTrials;
    trial.combine = "worse half";
    trial.renewal = kWallRenewal;
    return trial;
}

}  // namespace

void register_escape(GoalRegistry& goals) {
    goals.add({.id = "escape",
               .label = "Escape",
               .unit = "BL/s",
               .help = "Steady progress away from a wall that stands on the left or on the right, "
                       "in body lengths per second; the worse half of the trials counts nine "
                       "times as much as the mean.",
               .sample = "dodger",
               .default_environment =
                   [] {
                       Environment environment;
                       environment.has_wall = true;
                       return environment;
                   },
               .default_trial = balanced_sides(),
               .senses = {"obstacle-left", "obstacle-right"},
               .distractions = {"joint", "contact-distal", "contact-left", "contact-proximal",
                                "contact-right"},
               .may_give_up = false,
               .mismatch = needs_wall,
               .score = score_escape});
}

}  // namespace cambrian
