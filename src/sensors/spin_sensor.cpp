// Spin of the part in the world: 1 at 6 rad/s counter-clockwise, as a gyroscope feels it.

#include "sensors/frames.h"
#include "sensors/kinds.h"

namespace cambrian {
namespace {

constexpr double kSpinUnit = 6.0;  // rad/s

double read_spin(const SensorSite& site, double& /*memory*/) {
    const double spin = site.body.part_twist(site.index).angular.z();
    return limited_reading(site.handedness * spin / kSpinUnit);
}

}  // namespace

void add_spin_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "spin",
                 .label = "Spin",
                 .channels = {{"spin", "Spin"}},
                 .read = read_spin,
                 .usual = false});
}

}  // namespace cambrian
