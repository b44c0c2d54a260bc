#include "pictures/scene/organ_marks.h"

#include "pictures/scene/shown_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kMostSize = 0.05;    // m, radius of a sign
constexpr double kSizeShare = 0.5;    // of the narrower half extent
constexpr double kLeastPixels = 3.0;  // smaller signs are left out
constexpr double kInside = 0.6;       // share of the way to an end that signs at it have
const Color kSign = color_of(0x1B1E24);
const Color kMuscle = color_of(0xB5483A, 0.5F);

Vec2 planar_point(const Pose& pose, double x, double y) {
    return transform(pose, Vec3(x, y, 0.0)).head<2>();
}

// Two arcs that open along the part, as of a loudspeaker.
void add_arcs(SceneFrame& frame, const Pose& pose, double x, double size, double pixel) {
    const double angle = planar_angle(pose);
    const Vec2 center = planar_point(pose, x - 0.5 * size, 0.0);
    frame.add_circle(center, 0.22 * size, kSign);
    for (const double radius : {0.6, 1.1}) {
        frame.add_arc(center, radius * size, {angle - 0.8, angle + 0.8},
                      std::max(0.16 * size, pixel), kSign);
    }
}

// Three dots, the smallest at the part's near end.
void add_dots(SceneFrame& frame, const Pose& pose, double x, double size) {
    constexpr std::array<double, 3> radii = {0.2, 0.28, 0.36};
    constexpr std::array<double, 3> sides = {0.1, 0.45, -0.4};
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double along = x + (0.75 * static_cast<double>(i) - 0.75) * size;
        frame.add_circle(planar_point(pose, along, sides[i] * size), radii[i] * size, kSign);
    }
}

// Adds two arrows from the middle of a deformable part towards its ends.
void add_arrows(SceneFrame& frame, const Pose& pose, double half_length, double size,
                double pixel) {
    const double width = std::max(1.5 * pixel, 0.15 * size);
    for (const double side : {-1.0, 1.0}) {
        const double tip = side * kInside * half_length;
        const double barb = tip - side * 0.6 * size;
        const auto add = [&](const Vec3& from, const Vec3& to) {
            frame.add_line(transform(pose, from).head<2>(), transform(pose, to).head<2>(), width,
                           kMuscle);
        };
        add({0.3 * tip, 0.0, 0.0}, {tip, 0.0, 0.0});
        add({barb, 0.4 * size, 0.0}, {tip, 0.0, 0.0});
        add({barb, -0.4 * size, 0.0}, {tip, 0.0, 0.0});
    }
}

}  // namespace

void add_organ_marks(SceneFrame& frame, const Phenotype& phenotype, std::span<const Pose> poses,
                     std::span<const double> stretches, double pixel) {
    for (std::size_t i = 0; i < phenotype.organs.size(); ++i) {
        const GrownOrgan& organ = phenotype.organs[i];
        const auto before = std::count_if(
            phenotype.organs.begin(), phenotype.organs.begin() + static_cast<std::ptrdiff_t>(i),
            [&](const GrownOrgan& each) {
                return each.part == organ.part && each.place == organ.place;
            });
        const Vec3 half = shown_half_extents(phenotype.plan, stretches, organ.part);
        const double size = std::min(kMostSize, kSizeShare * std::min(half.x(), half.y()));
        if (size < kLeastPixels * pixel) continue;
        const double x =
            kInside * organ.place * half.x() + 2.2 * size * static_cast<double>(before);
        const Pose& pose = poses[organ.part];
        switch (organ.mark) {
            case OrganMark::kArcs:
            case OrganMark::kMouth:
                add_arcs(frame, pose, x, size, pixel);
                break;
            case OrganMark::kDots:
                add_dots(frame, pose, x, size);
                break;
            case OrganMark::kArrows:
                if (organ.deforms) add_arrows(frame, pose, half.x(), size, pixel);
                break;
        }
    }
}

}  // namespace cambrian
