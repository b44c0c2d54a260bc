// Strength of touch: the normal forces on the part, in units of the creature's weight on Earth.

#include "sensors/frames.h"
#include "sensors/kinds.h"

namespace cambrian {
namespace {

constexpr double kEarth = 9.81;  // m/s^2

double read_load(const SensorSite& site, double& /*memory*/) {
    return limited_reading(site.body.part_load(site.index) / (site.body.mass() * kEarth));
}

Vec3 load_spot(std::size_t /*channel*/, int /*handedness*/) {
    return {0.6, 0.0, 0.0};
}

}  // namespace

void add_load_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "load",
                 .label = "Load",
                 .channels = {{"load", "Load"}},
                 .read = read_load,
                 .spot = load_spot,
                 .reads_forces = true,
                 .usual = false});
}

}  // namespace cambrian
