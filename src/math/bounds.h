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

inline Bounds moved(const Bounds& bounds, const Vec3& shift) {
    return {bounds.low + shift, bounds.high + shift};
}

}  // namespace cambrian
