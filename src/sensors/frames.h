#pragma once

// Directions as the sensors of a part feel them.

#include "math/pose.h"
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
    const Vec3 axis = site.channel == 0 ? Vec3::UnitX() : Vec3(0.0, site.handedness, 0.0);
    return vector.dot(site.body.part_pose(site.index).orientation * axis);
}

// Spots of a pair of channels, the second on the part's left, `along` and `across` from the middle
// as shares of the half extents.
inline Vec3 paired_spot(std::size_t channel, int handedness, double along, double across) {
    return channel == 0 ? Vec3(along, 0.0, 0.0) : Vec3(0.0, handedness * across, 0.0);
}

}  // namespace cambrian
