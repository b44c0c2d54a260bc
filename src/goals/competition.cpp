// Competition, goals/README.md 6. With d the distance of a creature to the centre of the cube at
// the end,
//
//     f1 = 1 + (d2 - d1) / (d1 + d2),
//
// between 0 and 2, of which the opponent has the rest (Sims 1994b).
#include "goals/contest_score.h"
#include "goals/goal.h"
#include "goals/mismatch.h"

namespace cambrian {
namespace {

Score score_competition(const TrialRecord& record) {
    if (!record.bout) return {};
    return {contest_score(*record.bout),
            {{"own distance to the cube", record.bout->own, "m"},
             {"opponent's distance to the cube", record.bout->other, "m"}}};
}

TrialSettings bouts() {
    TrialSettings trial;
    trial.duration = 12.0;
    trial.has_cube = true;
    trial.trials = 3;
    return trial;
}

}  // namespace

void register_competition(GoalRegistry& goals) {
    goals.add({.id = "competition",
               .label = "Competition",
               .unit = "points",
               .help = "Nearer to a cube than an opponent, from 0 to 2 points.",
               .sample = "porter",
               .default_environment = [] { return Environment{}; },
               .default_trial = bouts(),
               .may_give_up = false,
               .is_contest = true,
               .mismatch = needs_level_ground,
               .score = score_competition});
}

}  // namespace cambrian
