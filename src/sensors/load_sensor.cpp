// Load: the sum of the normal forces on the part, in units of the creature's weight on Earth.

#include "sensors/frames.h"
#include "sensors/kinds.h"
#include "world/environment.h"

namespace cambrian {
namespace {

double read_load(const SensorSite& site, double& /*memory*/) {
    return limited_reading(site.body.part_load(site.index) / (site.body.mass() * kEarthGravity));
}

Vec3 load_spot(std::size_t /*channel*/, int /*handedness*/) {
    return {0.6, 0.0, 0.0};
}

}  // namespace

void add_load_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "load",
                 .label = "Load",
                 .group = "Strength of touch",
                 .channels = {{"load", "Load"}},
                 .read = read_load,
                 .spot = load_spot,
                 .reads_forces = true,
                 .usual = false});
}

}  // namespace cambrian
