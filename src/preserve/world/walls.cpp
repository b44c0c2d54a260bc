#include "preserve/world/walls.h"

#include "preserve/world/soft_spring.h"

#include <limits>

namespace cambrian {
namespace {

struct Excess {
    std::size_t part = 0;
    Vec3 corner = Vec3::Zero();  // m
    Vec3 inward = Vec3::Zero();  // unit vector
    double depth = 0.0;          // m
};

void note(Excess& worst, std::size_t part, const Vec3& corner, const Vec3& inward, double depth) {
    if (depth > worst.depth) worst = {part, corner, inward, depth};
}

Excess worst_excess(std::span<const Rectangle> parts, const WorldArea& area) {
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    const double left = area.has_sides() ? area.left() : -kNowhere;
    const double top = area.has_top() ? area.top() : kNowhere;
    const double bottom = area.has_bottom() ? area.bottom() : -kNowhere;
    Excess worst;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (const Vec3& corner : corners_of(parts[i])) {
            note(worst, i, corner, Vec3::UnitX(), left - corner.x());
            note(worst, i, corner, -Vec3::UnitX(), corner.x() + left);
            note(worst, i, corner, -Vec3::UnitY(), corner.y() - top);
            note(worst, i, corner, Vec3::UnitY(), bottom - corner.y());
        }
    }
    return worst;
}

}  // namespace

void push_back(PhysicsScene& scene, const Phenotype& phenotype, std::span<const Rectangle> parts,
               const WorldArea& area, double density) {
    const Excess worst = worst_excess(parts, area);
    if (!(worst.depth > 0.0)) return;
    const Rectangle& part = parts[worst.part];
    const Twist twist = scene.part_twist(worst.part);
    const Vec3 arm = worst.corner - part.center;
    const Vec3 velocity = twist.linear + twist.angular.cross(arm);
    const double mass =
        density * phenotype.parts[worst.part].length * phenotype.parts[worst.part].width;
    const double force = mass * spring_force(worst.depth, velocity.dot(worst.inward));
    if (!(force > 0.0)) return;
    const Vec3 point(arm.dot(part.axis), arm.dot(part.across()), 0.0);
    scene.pull(worst.part, point, force * worst.inward);
}

}  // namespace cambrian
