// Fleeing, goals/README.md 8. A light that hunts follows the creature and appears in a new place
// again and again. A leg is the time from one appearance to the next. Only progress away from where
// the light appeared counts. With p1 and p2 that of the centre of mass in [.2, .6] and [.6, 1] of a
// leg of the length t:
//
//     s = max(0, 0.3 (p1 + p2) + 1.4 min(p)) / (BL * 0.8 t)
//     S = 0.1 mean(s) + 0.9 mean(worse half of s)
//
// The legs of all trials count together. Trials are pairs of mirror images, so a creature that
// always moves one way has nothing in the worse half.
#include "core/sample_statistics.h"
#include "goals/goal.h"
#include "goals/mismatch.h"
#include "goals/sampling.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kFleePeriod = 7.5;     // s
constexpr double kHunterNearest = 1.5;  // body lengths
constexpr double kHunterFarthest = 2.0;
constexpr int kFleeTrials = 4;    // two pairs
constexpr int kFleeRenewal = 5;   // generations
constexpr double kIgnored = 0.2;  // share of a leg, in which a creature turns

Vec3 place_at(const TrialRecord& record, double time) {
    return sample_at(record, time / record.duration).center_of_mass;
}

double flight(const TrialRecord& record, const LightLeg& leg, double end) {
    const double length = (1.0 - kIgnored) * (end - leg.time);
    if (!(length > 0.0 && record.body_length > 0.0)) return 0.0;
    const double first = place_at(record, end - length).dot(leg.direction);
    const double middle = place_at(record, end - 0.5 * length).dot(leg.direction);
    const double last = place_at(record, end).dot(leg.direction);
    const double credit = 0.3 * (first - last) + 1.4 * std::min(first - middle, middle - last);
    return std::max(0.0, credit) / (record.body_length * length);
}

std::vector<double> flights(const TrialRecord& record) {
    std::vector<double> shares;
    const std::vector<LightLeg>& legs = record.legs.all();
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const double end = i + 1 < legs.size() ? legs[i + 1].time : record.duration;
        shares.push_back(flight(record, legs[i], end));
    }
    return shares;
}

double score_of_flights(std::span<const double> shares) {
    if (shares.empty()) return 0.0;
    return 0.1 * mean(shares) + 0.9 * mean_of_worse_half({shares.begin(), shares.end()});
}

Score score_fleeing(const TrialRecord& record) {
    const std::vector<double> shares = flights(record);
    if (shares.empty()) return {};
    return {score_of_flights(shares),
            {{"mean flight", mean(shares), "BL/s"},
             {"slowest flight", *std::min_element(shares.begin(), shares.end()), "BL/s"},
             {"body length", record.body_length, "m"}}};
}

Environment hunted_land() {
    Environment environment;
    environment.has_light = true;
    environment.light_motion = "hunting";
    environment.light_nearest = kHunterNearest;
    environment.light_farthest = kHunterFarthest;
    environment.light_period = kFleePeriod;
    return environment;
}

TrialSettings hunted_trials() {
    TrialSettings trial;
    trial.trials = kFleeTrials;
    trial.renewal = kFleeRenewal;
    return trial;
}

}  // namespace

void register_fleeing(GoalRegistry& goals) {
    goals.add({.id = "fleeing",
               .label = "Fleeing",
               .unit = "BL/s",
               .help = "Steady progress away from a light that follows and appears on either side, "
                       "in body lengths per second; the worse half of its appearances counts nine "
                       "times as much as the mean.",
               .sample = "bolter",
               .default_environment = hunted_land,
               .default_trial = hunted_trials(),
               .senses = {"light-along", "light-across"},
               .distractions = {"joint", "contact-distal", "contact-left", "contact-proximal",
                                "contact-right"},
               .may_give_up = false,
               .mismatch = needs_hunting_light,
               .score = score_fleeing,
               .shares = flights,
               .score_of_shares = score_of_flights});
}

}  // namespace cambrian
