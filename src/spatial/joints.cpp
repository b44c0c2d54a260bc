// Joints in space. With the lesser widths w and depths d of the two parts, the strength of a bend
// about z is proportional to d w^2, about y to w d^2, of a twist to (w d)^1.5 and of a slide to w
// d, because a thicker muscle also has a longer lever.

#include "spatial/joints.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kMostSwing = 2.2;      // rad; a ball's twist turns fast where it nears pi
constexpr double kMostExtension = 0.9;  // share of the part's length, in both directions

DegreeLimits hinge(const JointGenes& genes, int axis, double low, double high) {
    const bool mirrored = genes.mirror.of_turn(axis) < 0;
    const double area = genes.width * genes.depth;
    const double lever = axis == 0 ? std::sqrt(area) : axis == 1 ? genes.depth : genes.width;
    return {mirrored ? -high : low, mirrored ? -low : high, genes.muscle_strength * area * lever};
}

// Sets the axes of hinges in the order in which they turn one another.
template <int... kAxes>
void shape_hinges(const JointGenes& genes, PlannedPart& part) {
    const std::array<int, sizeof...(kAxes)> axes = {kAxes...};
    const DegreeLimits first = hinge(genes, axes[0], genes.limit_low, genes.limit_high);
    part.limit_low = first.low;
    part.limit_high = first.high;
    part.max_effort = first.max_effort;
    part.degree_count = static_cast<std::uint8_t>(axes.size());
    for (std::size_t d = 0; d < axes.size(); ++d) {
        part.axes[d] = static_cast<std::uint8_t>(axes[d]);
        if (d == 0) continue;
        const auto& limits = genes.further_limits[d - 1];
        part.further[d - 1] = hinge(genes, axes[d], limits[0], limits[1]);
    }
}

// The cone of both bends has the mean of the first's limits; the genes of the second stay unused.
void shape_ball(const JointGenes& genes, PlannedPart& part) {
    shape_hinges<2, 1, 0>(genes, part);
    const double swing = std::fmin(0.5 * (genes.limit_high - genes.limit_low), kMostSwing);
    part.limit_low = -swing;
    part.limit_high = swing;
    part.further[0].low = -swing;
    part.further[0].high = swing;
}

void shape_slide(const JointGenes& genes, PlannedPart& part) {
    part.limit_low = std::fmax(genes.limit_low, -kMostExtension) * genes.length;
    part.limit_high = std::fmin(genes.limit_high, kMostExtension) * genes.length;
    part.max_effort = genes.muscle_strength * genes.width * genes.depth;
}

}  // namespace

JointRegistry spatial_joints() {
    constexpr int x = 0;
    constexpr int y = 1;
    constexpr int z = 2;
    JointRegistry joints;
    joints.add({.id = "rigid", .label = "Rigid", .motion = JointMotion::kFixed});
    joints.add({.id = "rotary",
                .label = "Revolute",
                .motion = JointMotion::kTurn,
                .shape = shape_hinges<z>});
    joints.add({.id = "linear",
                .label = "Prismatic",
                .motion = JointMotion::kSlide,
                .usual = false,
                .shape = shape_slide});
    joints.add(
        {.id = "twist", .label = "Twist", .motion = JointMotion::kTurn, .shape = shape_hinges<x>});
    joints.add({.id = "universal",
                .label = "Universal",
                .motion = JointMotion::kTurn,
                .shape = shape_hinges<z, y>,
                .turns = 2});
    joints.add({.id = "bend-twist",
                .label = "Bend and twist",
                .motion = JointMotion::kTurn,
                .shape = shape_hinges<z, x>,
                .turns = 2});
    joints.add({.id = "twist-bend",
                .label = "Twist and bend",
                .motion = JointMotion::kTurn,
                .shape = shape_hinges<x, z>,
                .turns = 2});
    joints.add({.id = "spherical",
                .label = "Spherical",
                .motion = JointMotion::kBall,
                .shape = shape_ball,
                .turns = 3});
    return joints;
}

}  // namespace cambrian
