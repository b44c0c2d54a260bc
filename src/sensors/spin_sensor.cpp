// Angular velocity of the part in the world, as of a gyroscope: 1 at 6 rad/s counter-clockwise.

#include "sensors/frames.h"
#include "sensors/kinds.h"

namespace cambrian {
namespace {

constexpr double kSpinUnit = 6.0;  // rad/s that read as 1

double read_spin(const SensorSite& site, double& /*memory*/) {
    const double spin = site.body.part_twist(site.index).angular.z();
    return limited_reading(site.handedness * spin / kSpinUnit);
}

}  // namespace

void add_spin_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "spin",
                 .label = "Spin",
                 .group = "Proprioception",
                 .channels = {{"spin", "Spin"}},
                 .read = read_spin,
                 .usual = false});
}

}  // namespace cambrian
