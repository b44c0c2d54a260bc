// Seeking, goals/README.md 4. The distance to the light changes from r0 to r1 in each leg, the time
// between two jumps of the light. With L0 the body length when the leg began and L at the end:
//
//     p = clamp((r0 - r1) / r0, -1, 1) L0 / L,    S = mean(p) / 2 + mean(worst half of all p) / 2
//
// The legs of all trials count together. Trials are pairs of mirror images and the worse half
// counts twice, so a creature that always moves one way loses more than it gains.
#include "core/sample_statistics.h"
#include "goals/goal.h"
#include "goals/mismatch.h"
#include "goals/water.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kReached = 0.5;    // body lengths
constexpr double kDuration = 25.0;  // s
constexpr int kTrials = 4;          // two pairs
constexpr int kRenewal = 10;        // generations

// Returns the share of the way that a body of this length (m) should have gone. A body that was
// shorter when the leg began had a shorter way.
double progress(const LightLeg& leg, double length) {
    if (!(leg.start > 0.0)) return 0.0;
    return std::clamp((leg.start - leg.end) / leg.start, -1.0, 1.0) * (leg.unit / length);
}

std::vector<double> leg_shares(const TrialRecord& record) {
    std::vector<double> shares;
    for (const LightLeg& leg : record.legs.all())
        shares.push_back(progress(leg, record.body_length));
    return shares;
}

double score_of_legs(std::span<const double> shares) {
    if (shares.empty()) return 0.0;
    return 0.5 * mean(shares) + 0.5 * mean_of_worse_half({shares.begin(), shares.end()});
}

Score score_seeking(const TrialRecord& record) {
    const std::vector<double> shares = leg_shares(record);
    if (shares.empty() || !(record.body_length > 0.0)) return {};
    double reached = 0.0;
    double distance = 0.0;
    for (const LightLeg& leg : record.legs.all()) {
        reached += leg.nearest < kReached * record.body_length ? 1.0 : 0.0;
        distance += leg.mean;
    }
    return {score_of_legs(shares),
            {{"mean approach", mean(shares), ""},
             {"legs that reached it", reached, ""},
             {"mean distance", distance / static_cast<double>(shares.size()) / record.body_length,
              "body lengths"}}};
}

Environment lit_water() {
    Environment environment = water();
    environment.has_light = true;
    environment.light_motion = "jumping";
    return environment;
}

TrialSettings pairs_of_trials() {
    TrialSettings trial;
    trial.duration = kDuration;
    trial.trials = kTrials;
    trial.renewal = kRenewal;
    return trial;
}

}  // namespace

void register_seeking(GoalRegistry& goals) {
    goals.add({.id = "seeking",
               .label = "Seeking",
               .unit = "points",
               .help = "The share of the way to a jumping light that is covered, on average and "
                       "in the worse half of the legs; 1 at most.",
               .sample = "manta",
               .default_environment = lit_water,
               .default_trial = pairs_of_trials(),
               .senses = {"light-along", "light-across", "light"},
               .may_give_up = false,
               .mismatch = needs_jumping_light,
               .least_score = -1.0,
               .score = score_seeking,
               .shares = leg_shares,
               .score_of_shares = score_of_legs});
}

}  // namespace cambrian
