// Stretch of a deformable part and its rate: 1 at the greatest stretch that genes allow, and at the
// fastest of its muscle. Rigid parts read 0. Mirroring changes neither.

#include "sensors/frames.h"
#include "sensors/kinds.h"

namespace cambrian {
namespace {

constexpr double kFullStretch = 0.5;
constexpr double kFullRate = 1.5;  // 1/s

double read_stretch(const SensorSite& site, double& /*memory*/) {
    return limited_reading(site.channel == 0 ? site.body.stretch(site.index) / kFullStretch
                                             : site.body.stretch_rate(site.index) / kFullRate);
}

Vec3 stretch_spot(std::size_t channel, int /*handedness*/) {
    return {channel == 0 ? 0.1 : 0.3, 0.0, 0.0};
}

}  // namespace

void add_stretch_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "stretch",
                 .label = "Stretch",
                 .group = "Proprioception",
                 .channels = {{"stretch", "Stretch of the part"},
                              {"stretch-rate", "Stretch rate of the part"}},
                 .read = read_stretch,
                 .spot = stretch_spot,
                 .usual = false});
}

}  // namespace cambrian
