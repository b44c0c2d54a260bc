// Nose: the logarithm of the concentration of scent at the part's far end. The difference of two
// noses is the same however strong the scent is.

#include "sensors/kinds.h"
#include "sensors/smelling.h"

namespace cambrian {
namespace {

double read_smell(const SensorSite& site, double& /*memory*/) {
    const Vec3 nose = point_on_axis(site.body, site.index, 1.0);
    return smell_reading(site.surroundings.scent(nose));
}

Vec3 smell_spot(std::size_t /*channel*/, int /*handedness*/) {
    return {0.9, 0.0, 0.0};
}

}  // namespace

void add_smell_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "smell",
                 .label = "Smell",
                 .group = "Smell",
                 .channels = {{"smell", "Smell"}},
                 .read = read_smell,
                 .spot = smell_spot,
                 .smells = true,
                 .usual = false});
}

}  // namespace cambrian
