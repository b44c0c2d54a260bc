#pragma once

// The area of a preserve. The origin is its middle or, with ground, the middle of the ground.

#include "core/result.h"
#include "evolution/settings/preserve_settings.h"
#include "math/torus.h"
#include "math/types.h"
#include "world/environment.h"
#include "world/terrain.h"

#include <algorithm>
#include <memory>
#include <string>

namespace cambrian {

struct ExperimentSettings;

struct WorldArea {
    double width = 0.0;       // m
    double height = 0.0;      // m
    bool has_ground = false;  // at height 0, in place of the lower wall
    bool wraps = false;       // opposite edges meet; with ground, the left and the right one
    std::shared_ptr<const Terrain> ground = nullptr;  // its shape; null if it is flat
    double lowest = 0.0;                              // m, of the ground; at most 0

    double left() const { return -0.5 * width; }
    double bottom() const { return has_ground ? lowest : -0.5 * height; }
    double top() const { return has_ground ? height : 0.5 * height; }
    Vec3 middle() const { return {0.0, has_ground ? 0.5 * height : 0.0, 0.0}; }
    // Whether there are walls there.
    bool has_sides() const { return !wraps; }
    bool has_top() const { return !wraps || has_ground; }
    bool has_bottom() const { return !wraps && !has_ground; }
    Torus torus() const { return {has_sides() ? 0.0 : width, has_top() ? 0.0 : height}; }

    bool contains(const Vec3& point) const {
        return std::max(point.x(), -point.x()) <= 0.5 * width && point.y() >= bottom() &&
               point.y() <= top();
    }
    // Returns whether a circle is between the walls. It may reach below the ground, as the circle
    // around a standing creature does. Where edges meet, it may be anywhere that it does not reach
    // itself.
    bool holds(const Vec3& center, double radius) const {
        const double x = has_sides() ? std::max(center.x(), -center.x()) : 0.0;
        const double y = has_top() ? center.y() : 0.0;
        return x + radius <= 0.5 * width && y + radius <= top() &&
               (has_ground || y - radius >= bottom());
    }
    // Returns the nearest point between the walls.
    Vec3 between_walls(const Vec3& point) const {
        return {has_sides() ? std::clamp(point.x(), left(), -left()) : point.x(),
                has_top() ? std::clamp(point.y(), bottom(), top()) : point.y(), 0.0};
    }
    // Returns the image of that point in the area.
    Vec3 nearest(const Vec3& point) const { return torus().shortest(between_walls(point)); }
    double ground_at(double x) const { return ground ? ground->height(x) : 0.0; }  // m
    // Returns the height of the ground or the lower edge at x, in m.
    double foot_at(double x) const { return has_ground ? ground_at(x) : bottom(); }
    Bounds bounds() const { return {{left(), bottom(), 0.0}, {-left(), top(), 0.0}}; }
};

// Returns the environment of the creatures of a preserve. Ground with a shape follows from the
// seed, and joins itself where edges meet.
Environment world_environment(const ExperimentSettings& settings);
// Returns the area with its ground. Fails for points that make none.
Result<WorldArea> world_area(const ExperimentSettings& settings);

// Returns "40 m x 25 m", and that it is above the ground if there is one.
std::string size_text(const WorldArea& area);

// Returns the area without the shape of its ground.
inline WorldArea area_of(const PreserveSettings& settings, const Environment& environment) {
    return {settings.width, settings.height, environment.has_ground, wraps(settings)};
}

}  // namespace cambrian
