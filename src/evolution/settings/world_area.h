#pragma once

// The area of a preserve. The origin is its middle or, with ground, the middle of the ground.

#include "evolution/settings/preserve_settings.h"
#include "math/types.h"
#include "world/environment.h"

#include <algorithm>
#include <string>

namespace cambrian {

struct WorldArea {
    double width = 0.0;       // m
    double height = 0.0;      // m
    bool has_ground = false;  // at height 0, in place of the lower wall

    double left() const { return -0.5 * width; }
    double bottom() const { return has_ground ? 0.0 : -0.5 * height; }
    double top() const { return has_ground ? height : 0.5 * height; }
    Vec3 middle() const { return {0.0, has_ground ? 0.5 * height : 0.0, 0.0}; }

    bool contains(const Vec3& point) const {
        return std::max(point.x(), -point.x()) <= 0.5 * width && point.y() >= bottom() &&
               point.y() <= top();
    }
    // Returns whether a circle is between the walls. It may reach below the ground, as the circle
    // around a standing creature does.
    bool holds(const Vec3& center, double radius) const {
        return std::max(center.x(), -center.x()) + radius <= 0.5 * width &&
               center.y() + radius <= top() && (has_ground || center.y() - radius >= bottom());
    }
    // Returns the nearest point between the walls.
    Vec3 nearest(const Vec3& point) const {
        return {std::clamp(point.x(), left(), -left()), std::clamp(point.y(), bottom(), top()),
                0.0};
    }
    // With ground, returns the part of the area up to this height (m).
    WorldArea up_to(double limit) const {
        return has_ground ? WorldArea{width, std::min(height, limit), true} : *this;
    }
};

// Returns "40 m x 25 m", and that it is above the ground if there is one.
std::string size_text(const WorldArea& area);

inline WorldArea area_of(const PreserveSettings& settings, const Environment& environment) {
    return {settings.width, settings.height, environment.has_ground};
}

}  // namespace cambrian
