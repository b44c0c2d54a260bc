// Hunger: the creature's own store of energy, as a share of that of a newborn. It is 0 outside of a
// preserve.

#include "sensors/kinds.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kMostEnergy = 4.0;  // stores at birth

double read_energy(const SensorSite& site, double& /*memory*/) {
    return std::min(kMostEnergy, site.surroundings.energy());
}

}  // namespace

void add_hunger_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "stored-energy",
                 .label = "Hunger",
                 .group = "Hunger",
                 .channels = {{"energy", "Energy left"}},
                 .read = read_energy,
                 .usual = false});
}

}  // namespace cambrian
