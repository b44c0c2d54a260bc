// Light: the direction to it along and across the part (Sims 1994), and its intensity at the part's
// centre. No part casts a shadow.

#include "sensors/frames.h"
#include "sensors/kinds.h"

namespace cambrian {
namespace {

constexpr std::size_t kIntensity = 2;  // channel; those before are the direction's

double read_light(const SensorSite& site, double& /*memory*/) {
    const Light light = site.surroundings.light(site.body.part_center(site.index));
    if (site.channel == kIntensity) return limited_reading(light.intensity);
    return component(site, light.direction);
}

Vec3 light_spot(std::size_t channel, int handedness) {
    return channel == kIntensity ? Vec3(Vec3::Zero()) : paired_spot(channel, handedness, 0.75, 0.6);
}

}  // namespace

void add_light_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "light",
                 .label = "Light",
                 .group = "Light",
                 .channels = {{"light-along", "Light, along"},
                              {"light-across", "Light, across"},
                              {"light", "Light, intensity"}},
                 .read = read_light,
                 .spot = light_spot,
                 .usual = false});
}

}  // namespace cambrian
