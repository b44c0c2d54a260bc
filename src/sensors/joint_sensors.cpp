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

// Reads a further degree of freedom, whose sign is that of its turn; 0 where the joint has none.
template <class Read>
double read_further(const SensorSite& site, std::size_t degree, Read read) {
    if (degree >= degrees_of(site.part)) return 0.0;
    const int sign = site.mirror.of_turn(site.part.axes[degree]);
    return sign * read(JointDegree{static_cast<std::uint16_t>(site.index),
                                   static_cast<std::uint8_t>(degree)});
}

template <std::size_t kDegree>
double read_further_angle(const SensorSite& site, double& /*memory*/) {
    return read_further(site, kDegree, [&site](const JointDegree& degree) {
        return site.body.joint_coordinate(degree);
    });
}

double read_further_rate(const SensorSite& site, double& /*memory*/) {
    return read_further(site, 1 + site.channel, [&site](const JointDegree& degree) {
        return limited_reading(site.body.joint_rate(degree) / kTurn);
    });
}

double read_further_effort(const SensorSite& site, double& /*memory*/) {
    return read_further(site, 1 + site.channel, [&site](const JointDegree& degree) {
        const double most = limits_of(site.part, degree.degree).max_effort;
        return most > 0.0 ? std::clamp(site.body.joint_effort(degree) / most, -1.0, 1.0) : 0.0;
    });
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
                 .read = read_further_angle<1>});
}

// The twist of a ball; 0 where a joint has less than three degrees of freedom.
void add_third_degree_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "joint-3",
                 .label = "Joint, third angle",
                 .group = "Joint and touch",
                 .channels = {{"joint-3", "Joint, third angle"}},
                 .read = read_further_angle<2>});
}

// Rates and efforts of the second and third degrees of freedom, in the units of the first.
void add_further_rate_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "further-rates",
                 .label = "Further joint rates",
                 .group = "Proprioception",
                 .channels = {{"joint-rate-2", "Joint rate, second angle"},
                              {"joint-rate-3", "Joint rate, third angle"}},
                 .read = read_further_rate,
                 .spot = [](std::size_t, int) { return Vec3(-0.55, 0.0, 0.0); },
                 .usual = false});
}

void add_further_effort_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "further-efforts",
                 .label = "Further muscle efforts",
                 .group = "Proprioception",
                 .channels = {{"effort-2", "Muscle effort, second angle"},
                              {"effort-3", "Muscle effort, third angle"}},
                 .read = read_further_effort,
                 .spot = [](std::size_t, int) { return Vec3(-0.3, 0.0, 0.0); },
                 .usual = false});
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
