// Senses of the ground near a part, in the plane: whiskers that feel it before they touch it, and
// its height to either side.

#include "sensors/frames.h"
#include "sensors/kinds.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kWhisker = 1.0;      // m, length
constexpr double kAside = 0.5;        // m, from the part's centre
constexpr double kFullHeight = 0.25;  // m, which reads 1

// Faces in the order of the channels: far end, left, near end, right.
struct WhiskerFace {
    double along, across;  // of the face's normal
};
WhiskerFace whisker_face(std::size_t channel, int handedness) {
    constexpr double kAlong[] = {1.0, 0.0, -1.0, 0.0};
    constexpr double kAcross[] = {0.0, 1.0, 0.0, -1.0};
    return {kAlong[channel], kAcross[channel] * handedness};
}

double read_whisker(const SensorSite& site, double& /*memory*/) {
    const WhiskerFace face = whisker_face(site.channel, site.mirror.across);
    const Vec3 axis = site.body.part_axis(site.index);
    const Vec3 normal = face.along * axis + face.across * Vec3(-axis.y(), axis.x(), 0.0);
    const Vec3 half = site.body.part_half_extents(site.index);
    const double out = face.along != 0.0 ? half.x() : half.y();
    const Vec3 from = site.body.part_center(site.index) + out * normal;
    return std::max(0.0,
                    1.0 - site.surroundings.distance_to_ground(from, normal, kWhisker) / kWhisker);
}

Vec3 whisker_spot(std::size_t channel, int handedness) {
    constexpr double kShare = 0.95;
    const WhiskerFace face = whisker_face(channel, handedness);
    return {kShare * face.along, kShare * face.across, 0.0};
}

double read_rise(const SensorSite& site, double& /*memory*/) {
    const double x = site.body.part_center(site.index).x();
    const int direction = (site.channel == 0 ? -1 : 1) * site.mirror.across;
    const double rise = site.surroundings.ground_height(x + direction * kAside) -
                        site.surroundings.ground_height(x);
    return std::clamp(rise / kFullHeight, -1.0, 1.0);
}

}  // namespace

// Whiskers: how near ground or a wall is, out of the middle of each face along its normal. 1 means
// that it touches, 0 that there is none within 1 m. Sides are exchanged on mirrored parts.
void add_whisker_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "whisker",
                 .label = "Whiskers",
                 .group = "Whiskers",
                 .channels = {{"whisker-distal", "Whisker, far end"},
                              {"whisker-left", "Whisker, left"},
                              {"whisker-proximal", "Whisker, near end"},
                              {"whisker-right", "Whisker, right"}},
                 .read = read_whisker,
                 .spot = whisker_spot,
                 .feels_ground = true,
                 .usual = false});
}

// How much higher the ground is 0.5 m to the left and to the right, in the world, than below the
// part's centre: 1 at 0.25 m and more, -1 at a gap. Sides are exchanged on mirrored parts.
void add_rise_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "ground",
                 .label = "Height of the ground",
                 .group = "Height of the ground",
                 .channels = {{"ground-left", "Ground to the left"},
                              {"ground-right", "Ground to the right"}},
                 .read = read_rise,
                 .spot =
                     [](std::size_t channel, int handedness) {
                         return Vec3(0.2, (channel == 0 ? 0.5 : -0.5) * handedness, 0.0);
                     },
                 .feels_ground = true,
                 .usual = false});
}

}  // namespace cambrian
