// Senses of a part's joint to the parent and of its own stretch.

#include "sensors/frames.h"
#include "sensors/kinds.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kTurn = 6.0;   // rad/s that read as 1
constexpr double kSlide = 1.5;  // lengths of the part per second that read as 1
constexpr double kFullStretch = 0.5;
constexpr double kFullRate = 1.5;  // 1/s

double read_joint_rate(const SensorSite& site, double& /*memory*/) {
    const double rate = site.body.joint_rate(site.index);
    if (site.part.motion != JointMotion::kSlide)
        return limited_reading(joint_sign(site) * rate / kTurn);
    return limited_reading(rate / (kSlide * 2.0 * site.part.half_extents.x()));
}

double read_second_degree(const SensorSite& site, double& /*memory*/) {
    if (degrees_of(site.part) < 2) return 0.0;
    return turn_sign(site.part.axes[1], site.handedness, site.depth_sign) *
           site.body.joint_coordinate(JointDegree{static_cast<std::uint16_t>(site.index), 1});
}

double read_effort(const SensorSite& site, double& /*memory*/) {
    if (!(site.part.max_effort > 0.0)) return 0.0;
    const double share = site.body.joint_effort(site.index) / site.part.max_effort;
    return std::clamp(joint_sign(site) * share, -1.0, 1.0);
}

double read_stretch(const SensorSite& site, double& /*memory*/) {
    return limited_reading(site.channel == 0 ? site.body.stretch(site.index) / kFullStretch
                                             : site.body.stretch_rate(site.index) / kFullRate);
}

}  // namespace

// Coordinate of the joint, from rest, in rad or m. Mirror partners with mirrored bends have the
// same reading.
void add_joint_sensor(SensorRegistry& sensors) {
    sensors.add(
        {.id = "joint",
         .label = "Joint",
         .group = "Joint and touch",
         .channels = {{"joint", "Joint"}},
         .read = [](const SensorSite& site,
                    double&) { return joint_sign(site) * site.body.joint_coordinate(site.index); },
         .reads_joint = true});
}

// The second angle of a joint in space; 0 where a joint has one degree of freedom.
void add_second_degree_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "joint-2",
                 .label = "Joint, second angle",
                 .group = "Joint and touch",
                 .channels = {{"joint-2", "Joint, second angle"}},
                 .read = read_second_degree});
}

// Rate of the joint: 1 at 6 rad/s, or at 1.5 lengths of the part per second for a sliding joint,
// which mirroring does not change.
void add_joint_rate_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "joint-rate",
                 .label = "Joint rate",
                 .group = "Proprioception",
                 .channels = {{"joint-rate", "Joint rate"}},
                 .read = read_joint_rate,
                 .spot = [](std::size_t, int) { return Vec3(-0.55, 0.0, 0.0); },
                 .usual = false});
}

// Effort of the joint's motor, as a share of its maximum: -1 to 1.
void add_effort_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "effort",
                 .label = "Effort",
                 .group = "Proprioception",
                 .channels = {{"effort", "Muscle effort"}},
                 .read = read_effort,
                 .spot = [](std::size_t, int) { return Vec3(-0.3, 0.0, 0.0); },
                 .usual = false});
}

// Stretch of a deformable part and its rate: 1 at the greatest stretch that genes allow, and at the
// fastest of its muscle. Rigid parts read 0. Mirroring changes neither.
void add_stretch_sensor(SensorRegistry& sensors) {
    sensors.add(
        {.id = "stretch",
         .label = "Stretch",
         .group = "Proprioception",
         .channels = {{"stretch", "Stretch of the part"},
                      {"stretch-rate", "Stretch rate of the part"}},
         .read = read_stretch,
         .spot = [](std::size_t channel, int) { return Vec3(channel == 0 ? 0.1 : 0.3, 0.0, 0.0); },
         .usual = false});
}

}  // namespace cambrian
