// Balance: the direction against gravity, as components along and across the part. Without gravity
// both are 0.

#include "sensors/frames.h"
#include "sensors/kinds.h"

namespace cambrian {
namespace {

double read_balance(const SensorSite& site, double& /*memory*/) {
    return component(site, site.surroundings.up());
}

Vec3 balance_spot(std::size_t channel, int handedness) {
    return paired_spot(channel, handedness, 0.5, -0.35);
}

}  // namespace

void add_balance_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "balance",
                 .label = "Balance",
                 .group = "Balance",
                 .channels = {{"up-along", "Up, along"}, {"up-across", "Up, across"}},
                 .read = read_balance,
                 .spot = balance_spot,
                 .usual = false});
}

}  // namespace cambrian
