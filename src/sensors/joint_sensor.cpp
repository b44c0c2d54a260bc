// Coordinate of the joint to the parent, from rest, in rad or m. Mirror partners with mirrored
// bends have the same reading.

#include "sensors/kinds.h"

namespace cambrian {
namespace {

double read_joint(const SensorSite& site, double& /*memory*/) {
    return site.handedness * site.body.joint_coordinate(site.index);
}

}  // namespace

void add_joint_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "joint",
                 .label = "Joint",
                 .group = "Joint and touch",
                 .channels = {{"joint", "Joint"}},
                 .read = read_joint,
                 .reads_joint = true});
}

}  // namespace cambrian
