#pragma once

// Directions as the sensors of a part feel them.

#include "sensors/sensor.h"

#include <algorithm>

namespace cambrian {

inline constexpr double kMostReading = 10.0;  // either way, as of all signals (brain/README.md 1)

inline double limited_reading(double reading) {
    return std::clamp(reading, -kMostReading, kMostReading);
}

// The component of a world vector along the part's length (channel 0), or across it to the left
// (channel 1), right and left exchanged on mirrored parts.
inline double component(const SensorSite& site, const Vec3& vector) {
    const Vec3 axis = site.body.part_axis(site.index);
    if (site.channel == 0) return vector.dot(axis);
    return site.handedness * (axis.x() * vector.y() - axis.y() * vector.x());
}

// The sign of what the joint to the parent does: that of the handedness, 1 where it slides, for
// sliding has none.
inline int joint_sign(const SensorSite& site) {
    return site.part.motion == JointMotion::kSlide ? 1 : site.handedness;
}

// Spots of a pair of channels, the second on the part's left, `along` and `across` from the middle
// as shares of the half extents.
inline Vec3 paired_spot(std::size_t channel, int handedness, double along, double across) {
    return channel == 0 ? Vec3(along, 0.0, 0.0) : Vec3(0.0, handedness * across, 0.0);
}

}  // namespace cambrian
