#include "preserve/world/rectangle.h"

#include <algorithm>
#include <cmath>

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

double distance_to(const Rectangle& rectangle, const Vec3& point) {
    const Vec3 apart = point - rectangle.center;
    const double along =
        std::max(std::fabs(apart.dot(rectangle.axis)) - rectangle.half_length, 0.0);
    const double across =
        std::max(std::fabs(apart.dot(rectangle.across())) - rectangle.half_width, 0.0);
    return std::sqrt(along * along + across * across);
}

}  // namespace cambrian
