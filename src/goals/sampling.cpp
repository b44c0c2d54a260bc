#include "goals/sampling.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr std::array<double, 4> kWindowWeights = {1.0, 1.0, 2.0, 3.0};
constexpr double kTotalWeight = 7.0;

}  // namespace

std::size_t sample_index(const TrialRecord& record, double share) {
    CAMBRIAN_ASSERT(!record.samples.empty(), "a completed record has samples");
    const double last = static_cast<double>(record.samples.size() - 1);
    const double index = std::clamp(std::nearbyint(share * last), 0.0, last);
    return static_cast<std::size_t>(index);
}

const MotionSample& sample_at(const TrialRecord& record, double share) {
    return record.samples[sample_index(record, share)];
}

WindowSpeeds window_speeds(const TrialRecord& record, const Vec3& direction) {
    WindowSpeeds speeds = {};
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        const Vec3 moved = sample_at(record, kWindowStarts[i] + kWindow).center_of_mass -
                           sample_at(record, kWindowStarts[i]).center_of_mass;
        speeds[i] = moved.dot(direction) / (kWindow * record.duration);
    }
    return speeds;
}

double steady_speed(const WindowSpeeds& speeds) {
    double weighted = 0.0;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        weighted += kWindowWeights[i] * speeds[i];
    const double slowest = *std::min_element(speeds.begin(), speeds.end());
    return 0.5 * weighted / kTotalWeight + 0.5 * slowest;
}

}  // namespace cambrian
