// Swimming, goals/README.md 3. u is the direction from the centre of mass at 0.1 T to that at T;
// v1..v4 are mean speeds along u in the windows [.2,.4] [.4,.6] [.6,.8] [.8,1] T:
//
//     S = [ (v1 + v2 + 2 v3 + 3 v4) / 14 + min(v) / 2 ] / BL, at least 0
//
// The drift after one push decays, and circling makes no progress along one direction, so neither
// scores.
#include "goals/goal.h"
#include "goals/mismatch.h"
#include "goals/sampling.h"
#include "goals/water.h"

#include <algorithm>

namespace cambrian {
namespace {

Score score_swimming(const TrialRecord& record) {
    if (record.samples.empty() || !(record.duration > 0.0 && record.body_length > 0.0)) return {};
    const Vec3 path = sample_at(record, 1.0).center_of_mass - sample_at(record, 0.1).center_of_mass;
    const double distance = path.norm();
    if (!(distance > 0.0)) return {};
    const Vec3 direction = path / distance;
    const WindowSpeeds speeds = window_speeds(record, direction);
    return {std::max(0.0, steady_speed(speeds) / record.body_length),
            {{"distance", distance, "m"},
             {"slowest window", *std::min_element(speeds.begin(), speeds.end()), "m/s"},
             {"body length", record.body_length, "m"}}};
}

}  // namespace

void register_swimming(GoalRegistry& goals) {
    goals.add({.id = "swimming",
               .label = "Swimming",
               .unit = "BL/s",
               .help = "Steady progress through water along one line, in body lengths per second.",
               .sample = "dart",
               .default_environment = water,
               .default_give_up = true,
               .mismatch = needs_water,
               .score = score_swimming});
}

}  // namespace cambrian
