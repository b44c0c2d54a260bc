#include "preserve/world/rectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cambrian {

double half_projection(const Rectangle& rectangle, const Vec3& direction) {
    return rectangle.half_length * std::fabs(rectangle.axis.dot(direction)) +
           rectangle.half_width * std::fabs(rectangle.across().dot(direction));
}

Rectangle rectangle_of(const BodyView& body, std::size_t index, const Vec3& half_extents) {
    return {body.part_center(index), body.part_axis(index), half_extents.x(), half_extents.y()};
}

std::array<Vec3, 4> corners_of(const Rectangle& rectangle) {
    const Vec3 along = rectangle.half_length * rectangle.axis;
    const Vec3 across = rectangle.half_width * rectangle.across();
    return {rectangle.center + along + across, rectangle.center + along - across,
            rectangle.center - along + across, rectangle.center - along - across};
}

Bounds bounds_of(const Rectangle& rectangle) {
    Bounds bounds;
    for (const Vec3& corner : corners_of(rectangle))
        bounds.add(corner);
    return bounds;
}

Rectangle moved(const Rectangle& rectangle, const Vec3& shift) {
    Rectangle there = rectangle;
    there.center += shift;
    return there;
}

bool overlap(const Rectangle& a, const Rectangle& b) {
    const Vec3 apart = b.center - a.center;
    for (const Vec3& direction : {a.axis, a.across(), b.axis, b.across()}) {
        if (std::fabs(apart.dot(direction)) >
            half_projection(a, direction) + half_projection(b, direction))
            return false;
    }
    return true;
}

bool overlap(const Bounds& a, const Bounds& b, const Torus& torus) {
    bool met = false;
    torus.visit_images(a, b, [&](const Vec3& shift) { met = met || overlap(moved(a, shift), b); });
    return met;
}

namespace {

// Returns the height of the lower side of a rectangle at x, which must be within its bounds.
double lower_side(const Rectangle& rectangle, double x) {
    const std::array<Vec3, 4> corners = corners_of(rectangle);
    // The corners go round in this order.
    constexpr std::array<std::size_t, 4> kRound = {0, 1, 3, 2};
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < kRound.size(); ++i) {
        const Vec3& from = corners[kRound[i]];
        const Vec3& to = corners[kRound[(i + 1) % kRound.size()]];
        if (std::min(from.x(), to.x()) > x || std::max(from.x(), to.x()) < x) continue;
        const double width = to.x() - from.x();
        const double share = width == 0.0 ? 0.0 : (x - from.x()) / width;
        lowest = std::min(
            {lowest, from.y() + share * (to.y() - from.y()), width == 0.0 ? to.y() : lowest});
    }
    return lowest;
}

}  // namespace

// The ground and the sides are straight between these places.
double depth_below(const Terrain& ground, const Rectangle& rectangle) {
    double depth = -std::numeric_limits<double>::infinity();
    for (const Vec3& corner : corners_of(rectangle))
        depth = std::max(depth, ground.height(corner.x()) - corner.y());
    const Bounds bounds = bounds_of(rectangle);
    std::vector<GroundPoint> points;
    ground.list_points(bounds.low.x(), bounds.high.x(), points);
    for (const GroundPoint& point : points) {
        if (point.x >= bounds.low.x() && point.x <= bounds.high.x())
            depth = std::max(depth, point.y - lower_side(rectangle, point.x));
    }
    return depth;
}

double distance_to(const Rectangle& rectangle, const Vec3& point) {
    const Vec3 apart = point - rectangle.center;
    const double along =
        std::max(std::fabs(apart.dot(rectangle.axis)) - rectangle.half_length, 0.0);
    const double across =
        std::max(std::fabs(apart.dot(rectangle.across())) - rectangle.half_width, 0.0);
    return std::sqrt(along * along + across * across);
}

}  // namespace cambrian
