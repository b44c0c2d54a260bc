// Ears: the loudness of each of the four bands of sound at the part's centre. A creature does not
// hear itself.

#include "sensors/frames.h"
#include "sensors/kinds.h"

namespace cambrian {
namespace {

double read_sound(const SensorSite& site, double& /*memory*/) {
    const Vec3 center = site.body.part_center(site.index);
    return limited_reading(site.surroundings.sound(center, static_cast<int>(site.channel)));
}

// Places the bands in a row across the part.
Vec3 sound_spot(std::size_t channel, int handedness) {
    return {0.1, handedness * (0.45 - 0.3 * static_cast<double>(channel)), 0.0};
}

}  // namespace

void add_sound_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "sound",
                 .label = "Sound",
                 .group = "Sound",
                 .channels = {{"sound-1", "Sound, band 1"},
                              {"sound-2", "Sound, band 2"},
                              {"sound-3", "Sound, band 3"},
                              {"sound-4", "Sound, band 4"}},
                 .read = read_sound,
                 .spot = sound_spot,
                 .usual = false});
}

}  // namespace cambrian
