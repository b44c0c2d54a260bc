#include "simulator/jump_watch.h"

#include "simulator/settings/trial_settings.h"

#include <algorithm>

namespace cambrian {
namespace {

// A creature is on the ground while its lowest point is below this height, in m.
constexpr double kAirborne = 0.01;

}  // namespace

void JumpWatch::watch(double lowest, double center) {
    if (watched_ == 0 || lowest <= kAirborne) {
        stand(center);
    } else {
        fly(lowest, center);
    }
    measure_speed(center);
}

void JumpWatch::stand(double center) {
    flying_ = false;
    standing_[stood_ % kStanceTicks] = center;
    ++stood_;
}

void JumpWatch::fly(double lowest, double center) {
    if (!flying_) {
        flying_ = true;
        const auto known = static_cast<std::ptrdiff_t>(std::min(stood_, kStanceTicks));
        stance_ = *std::max_element(standing_.begin(), standing_.begin() + known);
        take_off_speed_ = (center - recent_[(watched_ - 1) % kSpeedTicks]) / kBrainTick;
    }
    const double rise = center - stance_;
    const double height = std::min(lowest, rise);
    if (height > best_.height) best_ = {height, lowest, rise, take_off_speed_};
}

void JumpWatch::measure_speed(double center) {
    double& oldest = recent_[watched_ % kSpeedTicks];
    if (watched_ >= kSpeedTicks) {
        constexpr double time = kSpeedTicks * kBrainTick;
        upward_speed_ = std::max(upward_speed_, (center - oldest) / time);
    }
    oldest = center;
    ++watched_;
}

}  // namespace cambrian
