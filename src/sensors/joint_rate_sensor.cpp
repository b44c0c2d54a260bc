// Rate of the joint to the parent: 1 at 6 rad/s, or at 1.5 lengths of the part per second for a
// sliding joint, which mirroring does not change.

#include "sensors/frames.h"
#include "sensors/kinds.h"

namespace cambrian {
namespace {

constexpr double kTurn = 6.0;   // rad/s that read as 1
constexpr double kSlide = 1.5;  // lengths of the part per second that read as 1

double read_joint_rate(const SensorSite& site, double& /*memory*/) {
    const double rate = site.body.joint_rate(site.index);
    if (site.part.motion != JointMotion::kSlide)
        return limited_reading(site.handedness * rate / kTurn);
    return limited_reading(rate / (kSlide * 2.0 * site.part.half_extents.x()));
}

Vec3 joint_rate_spot(std::size_t /*channel*/, int /*handedness*/) {
    return {-0.55, 0.0, 0.0};
}

}  // namespace

void add_joint_rate_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "joint-rate",
                 .label = "Joint rate",
                 .group = "Proprioception",
                 .channels = {{"joint-rate", "Joint rate"}},
                 .read = read_joint_rate,
                 .spot = joint_rate_spot,
                 .usual = false});
}

}  // namespace cambrian
