#pragma once

#include "math/types.h"

#include <limits>

namespace cambrian {

// An axis-aligned box, which is empty until a point is added.
struct Bounds {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());    // m
    Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());  // m

    void add(const Vec3& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
};

// Returns whether two boxes have a point in common.
inline bool overlap(const Bounds& a, const Bounds& b) {
    return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.y() <= b.high.y() &&
           b.low.y() <= a.high.y();
}

inline Bounds moved(const Bounds& bounds, const Vec3& shift) {
    return {bounds.low + shift, bounds.high + shift};
}

}  // namespace cambrian
