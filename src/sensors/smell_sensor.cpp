// Nose: the logarithm of the concentration of scent at the part's far end. The difference of two
// noses is the same however strong the scent is.

#include "math/elementary.h"
#include "sensors/frames.h"
#include "sensors/kinds.h"

namespace cambrian {
namespace {

constexpr double kLeastScent = 1e-3;  // units; less is hardly noticed
constexpr double kScale = 0.25;
constexpr double kMostSmell = 5.0;

double read_smell(const SensorSite& site, double& /*memory*/) {
    const Vec3 nose = point_on_axis(site.body, site.index, 1.0);
    const double scent = site.surroundings.scent(nose);
    return std::min(kMostSmell, kScale * logarithm(1.0 + scent / kLeastScent));
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
