// Accelerometer: the specific force at the part's centre along and across the part, in units of
// standard gravity, smoothed like a mass on a spring: y <- y + (x - y) (1 - exp(-dt / 50 ms)). At
// rest it reads 1 against gravity, in free fall 0.

#include "sensors/frames.h"
#include "sensors/kinds.h"
#include "world/environment.h"

namespace cambrian {
namespace {

constexpr double kTimeConstant = 0.05;  // s

double read_acceleration(const SensorSite& site, double& memory) {
    const double felt = component(site, site.body.part_specific_force(site.index)) / kEarthGravity;
    memory += (limited_reading(felt) - memory) * site.share;
    return memory;
}

Vec3 acceleration_spot(std::size_t channel, int handedness) {
    return paired_spot(channel, handedness, 0.25, 0.35);
}

}  // namespace

void add_accelerometer(SensorRegistry& sensors) {
    sensors.add({.id = "accelerometer",
                 .label = "Accelerometer",
                 .group = "Balance",
                 .channels = {{"accel-along", "Acceleration, along"},
                              {"accel-across", "Acceleration, across"}},
                 .read = read_acceleration,
                 .spot = acceleration_spot,
                 .time_constant = kTimeConstant,
                 .reads_forces = true,
                 .usual = false});
}

}  // namespace cambrian
