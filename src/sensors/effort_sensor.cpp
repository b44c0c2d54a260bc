// Effort of the motor of the joint to the parent, as a share of its maximum: -1 to 1.

#include "sensors/frames.h"
#include "sensors/kinds.h"

#include <algorithm>

namespace cambrian {
namespace {

double read_effort(const SensorSite& site, double& /*memory*/) {
    if (!(site.part.max_effort > 0.0)) return 0.0;
    const double share = site.body.joint_effort(site.index) / site.part.max_effort;
    return std::clamp(joint_sign(site) * share, -1.0, 1.0);
}

Vec3 effort_spot(std::size_t /*channel*/, int /*handedness*/) {
    return {-0.3, 0.0, 0.0};
}

}  // namespace

void add_effort_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "effort",
                 .label = "Effort",
                 .group = "Proprioception",
                 .channels = {{"effort", "Muscle effort"}},
                 .read = read_effort,
                 .spot = effort_spot,
                 .usual = false});
}

}  // namespace cambrian
