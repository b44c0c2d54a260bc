#include "preserve/bodies/crowding.h"

#include "preserve/world/soft_spring.h"

#include <cmath>

namespace cambrian {
namespace {

struct Overlap {
    std::size_t a = 0, b = 0;   // parts
    double depth = 0.0;         // m
    Vec3 away = Vec3::Zero();   // unit vector from b to a
    Vec3 point = Vec3::Zero();  // m
};

// Finds the direction in which a leaves b on the shortest way. The depth is negative if they do not
// overlap.
Overlap overlap_of(const Rectangle& a, const Rectangle& b) {
    Overlap least{.depth = 1e9};
    const Vec3 apart = a.center - b.center;
    for (const Vec3& axis : {a.axis, a.across(), b.axis, b.across()}) {
        const double distance = apart.dot(axis);
        const double depth =
            half_projection(a, axis) + half_projection(b, axis) - std::fabs(distance);
        if (depth >= least.depth) continue;
        least.depth = depth;
        least.away = distance < 0.0 ? Vec3(-axis) : axis;
    }
    return least;
}

Overlap deepest_overlap(const SweptBounds& a, const SweptBounds& b) {
    Overlap deepest;
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        for (std::size_t j = 0; j < b.parts.size(); ++j) {
            if (gap_between(a.boxes[i], b.boxes[j]) > 0.0) continue;
            Overlap found = overlap_of(a.parts[i], b.parts[j]);
            if (found.depth <= deepest.depth) continue;
            found.a = i;
            found.b = j;
            const Vec3 low = a.boxes[i].low.cwiseMax(b.boxes[j].low);
            const Vec3 high = a.boxes[i].high.cwiseMin(b.boxes[j].high);
            found.point = 0.5 * (low + high);
            deepest = found;
        }
    }
    return deepest;
}

Vec3 velocity_at(const PressedBody& body, std::size_t part, const Vec3& point) {
    const Twist twist = body.scene.part_twist(part);
    return twist.linear + twist.angular.cross(point - body.shift - body.scene.part_center(part));
}

void pull_at(const PressedBody& body, std::size_t part, const Vec3& point, const Vec3& force) {
    const Rectangle& place = body.extent.parts[part];
    const Vec3 arm = point - place.center;
    body.scene.pull(part, Vec3(arm.dot(place.axis), arm.dot(place.across()), 0.0), force);
    --body.room;
}

}  // namespace

bool press_apart(const PressedBody& a, const PressedBody& b) {
    if (a.room == 0 || b.room == 0) return false;
    const Overlap found = deepest_overlap(a.extent, b.extent);
    if (!(found.depth > 0.0)) return false;
    const Vec3 relative =
        velocity_at(a, found.a, found.point) - velocity_at(b, found.b, found.point);
    const double mass = a.scene.mass() * b.scene.mass() / (a.scene.mass() + b.scene.mass());
    const double force = mass * spring_force(found.depth, relative.dot(found.away));
    if (!(force > 0.0)) return false;
    pull_at(a, found.a, found.point, force * found.away);
    pull_at(b, found.b, found.point, -force * found.away);
    return true;
}

}  // namespace cambrian
