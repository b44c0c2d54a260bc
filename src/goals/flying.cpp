// Flying, goals/README.md 5. With v_k the mean speed upwards in the windows [.2,.4] [.4,.6] [.6,.8]
// [.8,1] T, and v_ref the slowest sink speed of passive bodies (simulator/passive_sink.h):
//
//     s_k = clamp(v_k / v_ref, -4, 1),   H = mean(s) / 2 + min(s) / 2
//     S = 2^H + P clamp(1 + H, 0, 1)
//
// P is the score of swimming to the left or the right. A stone scores 0.06, the best parachute 0.5,
// level flight 1. The size of a body earns nothing.
#include "goals/goal.h"
#include "goals/mismatch.h"
#include "goals/sampling.h"
#include "math/elementary.h"

#include <algorithm>
#include <numeric>

namespace cambrian {
namespace {

constexpr double kFastestFall = -4.0;  // passive sink speeds
constexpr double kFastestClimb = 1.0;  // the same
constexpr double kTouching = 0.01;     // m; a lowest point no higher than this is on the ground

// Returns the first window in which the creature touches the ground, or the number of windows.
std::size_t windows_in_air(const TrialRecord& record) {
    if (!record.has_ground) return kWindowStarts.size();
    for (const MotionSample& sample : record.samples) {
        const double share = sample.time / record.duration;
        if (share < kWindowStarts.front() || sample.bounds.low.y() > kTouching) continue;
        const auto next = std::upper_bound(kWindowStarts.begin(), kWindowStarts.end(), share);
        return static_cast<std::size_t>(next - kWindowStarts.begin()) - 1;
    }
    return kWindowStarts.size();
}

WindowSpeeds climbing(const TrialRecord& record) {
    WindowSpeeds speeds = window_speeds(record, Vec3::UnitY());
    for (double& speed : speeds)
        speed = std::clamp(speed / record.passive_sink, kFastestFall, kFastestClimb);
    std::fill(speeds.begin() + static_cast<std::ptrdiff_t>(windows_in_air(record)), speeds.end(),
              kFastestFall);
    return speeds;
}

Score score_flying(const TrialRecord& record) {
    if (record.samples.empty() || !(record.duration > 0.0 && record.body_length > 0.0)) return {};
    if (!(record.passive_sink > 0.0)) return {};
    const WindowSpeeds climbs = climbing(record);
    const double mean = std::accumulate(climbs.begin(), climbs.end(), 0.0) / climbs.size();
    const double height = 0.5 * mean + 0.5 * *std::min_element(climbs.begin(), climbs.end());
    const double lift = power(2.0, height);
    const double right = steady_speed(window_speeds(record, Vec3::UnitX()));
    const double left = steady_speed(window_speeds(record, -Vec3::UnitX()));
    const double travel = std::max({0.0, right, left}) / record.body_length;
    return {lift + travel * std::clamp(1.0 + height, 0.0, 1.0),
            {{"for height", lift, "points"},
             {"mean speed upwards", mean * record.passive_sink, "m/s"},
             {"slowest fall of what does nothing", record.passive_sink, "m/s"},
             {"travel", travel, "BL/s"}}};
}

Environment air() {
    Environment environment;
    environment.gravity = 0.25;
    environment.has_ground = false;
    environment.viscosity_linear = 0.02;
    environment.viscosity_quadratic = 0.2;
    return environment;
}

}  // namespace

void register_flying(GoalRegistry& goals) {
    goals.add({.id = "flying",
               .label = "Flying",
               .unit = "points",
               .help = "Staying up and climbing in thin air by flapping, then travel. The best "
                       "creature that falls without moving has 0.5; level flight has 1.",
               .sample = "butterfly",
               .default_environment = air,
               .may_give_up = false,
               .mismatch = needs_air,
               .score = score_flying});
}

}  // namespace cambrian
