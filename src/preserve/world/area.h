#pragma once

// The area between the walls of a preserve, with its middle at the origin.

#include "math/types.h"

#include <algorithm>

namespace cambrian {

struct WalledArea {
    double width = 0.0;   // m
    double height = 0.0;  // m

    double left() const { return -0.5 * width; }
    double bottom() const { return -0.5 * height; }
    // Returns whether a circle is between the walls.
    bool holds(const Vec3& center, double radius) const {
        return std::max(center.x(), -center.x()) + radius <= 0.5 * width &&
               std::max(center.y(), -center.y()) + radius <= 0.5 * height;
    }
    // Returns the nearest point between the walls.
    Vec3 nearest(const Vec3& point) const {
        return {std::clamp(point.x(), left(), -left()), std::clamp(point.y(), bottom(), -bottom()),
                0.0};
    }
};

}  // namespace cambrian
