// Jumping, goals/README.md 2: S = h + 0.2 min(max(c, 0), BL / 2), with h the greatest height of the
// lowest point above ground and c the greatest rise of the centre of mass above its settled height.
// The second term only gives selection something to climb before the first true jump.
#include "goals/goal.h"
#include "goals/mismatch.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kRiseShare = 0.2;

Score score_jumping(const TrialRecord& record) {
    if (record.samples.empty()) return {};
    double clearance = 0.0;
    double rise = 0.0;
    const double settled = record.samples.front().center_of_mass.y();
    for (const MotionSample& sample : record.samples) {
        clearance = std::max(clearance, sample.bounds.low.y());
        rise = std::max(rise, sample.center_of_mass.y() - settled);
    }
    const double credited_rise = kRiseShare * std::min(rise, 0.5 * record.body_length);
    return {clearance + credited_rise,
            {{"height of the lowest point", clearance, "m"},
             {"rise of the centre of mass", rise, "m"}}};
}

}  // namespace

void register_jumping(GoalRegistry& goals) {
    goals.add({.id = "jumping",
               .label = "Jumping",
               .unit = "m",
               .help = "Height of the lowest point above the ground at the top of the best jump.",
               .default_environment = [] { return Environment{}; },
               .mismatch = needs_ground,
               .score = score_jumping});
}

}  // namespace cambrian
