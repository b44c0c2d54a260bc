// Senses of a part's motion and of which way is up.

#include "sensors/frames.h"
#include "sensors/kinds.h"
#include "world/environment.h"

namespace cambrian {
namespace {

constexpr double kTimeConstant = 0.05;  // s
constexpr double kSpinUnit = 6.0;       // rad/s that read as 1

double read_acceleration(const SensorSite& site, double& memory) {
    const double felt = component(site, site.body.part_specific_force(site.index)) / kEarthGravity;
    memory += (limited_reading(felt) - memory) * site.share;
    return memory;
}

double read_spin(const SensorSite& site, double& /*memory*/) {
    const double spin = site.body.part_twist(site.index).angular.z();
    return limited_reading(site.mirror.across * spin / kSpinUnit);
}

}  // namespace

// Accelerometer: the specific force at the part's centre along and across the part, in units of
// standard gravity, smoothed like a mass on a spring: y <- y + (x - y) (1 - exp(-dt / 50 ms)). At
// rest it reads 1 against gravity, in free fall 0.
void add_accelerometer(SensorRegistry& sensors) {
    sensors.add(
        {.id = "accelerometer",
         .label = "Accelerometer",
         .group = "Balance",
         .channels = {{"accel-along", "Acceleration, along"},
                      {"accel-across", "Acceleration, across"}},
         .read = read_acceleration,
         .spot = [](std::size_t channel,
                    int handedness) { return paired_spot(channel, handedness, 0.25, 0.35); },
         .time_constant = kTimeConstant,
         .reads_forces = true,
         .usual = false});
}

// Angular velocity of the part in the world, as of a gyroscope: 1 at 6 rad/s counter-clockwise.
void add_spin_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "spin",
                 .label = "Spin",
                 .group = "Proprioception",
                 .channels = {{"spin", "Spin"}},
                 .read = read_spin,
                 .usual = false});
}

// Balance: the direction against gravity, as components along and across the part. Without gravity
// both are 0.
void add_balance_sensor(SensorRegistry& sensors) {
    sensors.add(
        {.id = "balance",
         .label = "Balance",
         .group = "Balance",
         .channels = {{"up-along", "Up, along"}, {"up-across", "Up, across"}},
         .read = [](const SensorSite& site,
                    double&) { return component(site, site.surroundings.up()); },
         .spot = [](std::size_t channel,
                    int handedness) { return paired_spot(channel, handedness, 0.5, -0.35); },
         .usual = false});
}

}  // namespace cambrian
