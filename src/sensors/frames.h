#pragma once

// Directions in the frame of a part, for sensors.

#include "sensors/sensor.h"
#include "world/joint_kind.h"

#include <algorithm>

namespace cambrian {

// Largest absolute reading, as for all signals (brain/README.md 1).
inline constexpr double kMostReading = 10.0;

inline double limited_reading(double reading) {
    return std::clamp(reading, -kMostReading, kMostReading);
}

// Returns the component of a world vector along the part's length (channel 0), or across it to the
// left (channel 1). Left and right are exchanged on mirrored parts.
inline double component(const SensorSite& site, const Vec3& vector) {
    const Vec3 axis = site.body.part_axis(site.index);
    if (site.channel == 0) return vector.dot(axis);
    return site.mirror.across * (axis.x() * vector.y() - axis.y() * vector.x());
}

// Returns the sign of a coordinate of the joint: that of the turn, or 1 for a sliding joint, which
// mirroring does not change.
inline int joint_sign(const SensorSite& site) {
    if (site.part.motion == JointMotion::kSlide) return 1;
    return site.mirror.of_turn(site.part.axes[0]);
}

// Returns the spots of a pair of channels, the second on the part's left. `along` and `across` are
// distances from the middle as shares of the half extents.
inline Vec3 paired_spot(std::size_t channel, int handedness, double along, double across) {
    return channel == 0 ? Vec3(along, 0.0, 0.0) : Vec3(0.0, handedness * across, 0.0);
}

}  // namespace cambrian
