// Jumping, goals/README.md 2. With J the height of the highest jump (simulator/jump_watch.h) and v
// the greatest upward speed of the centre of mass over 0.1 s:
//
//     S = J + 0.02 s * min(v, 2.5 m/s)
//
// The second term, at most 0.05 m, gives selection a gradient before the first true jump.
#include "goals/goal.h"
#include "goals/mismatch.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kSpeedWorth = 0.02;  // s
constexpr double kMostSpeed = 2.5;    // m/s

Score score_jumping(const TrialRecord& record) {
    const Jump& jump = record.jumps.best();
    const double speed = record.jumps.upward_speed();
    return {jump.height + kSpeedWorth * std::min(speed, kMostSpeed),
            {{"height of the best jump", jump.height, "m"},
             {"height of the lowest point", jump.clearance, "m"},
             {"rise of the centre of mass", jump.rise, "m"},
             {"speed at take-off", jump.take_off_speed, "m/s"},
             {"greatest upward speed", speed, "m/s"}}};
}

}  // namespace

void register_jumping(GoalRegistry& goals) {
    goals.add({.id = "jumping",
               .label = "Jumping",
               .unit = "m",
               .help = "The height of the best jump: of the lowest point above the ground, as far "
                       "as the body rose with it.",
               .sample = "leaper",
               .default_confirmations = 2,
               .default_environment = [] { return Environment{}; },
               .mismatch = needs_ground,
               .score = score_jumping});
}

}  // namespace cambrian
