#include "pictures/scene/organ_marks.h"

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

}  // namespace

void add_organ_marks(SceneFrame& frame, const Phenotype& phenotype, std::span<const Pose> poses,
                     double pixel) {
    for (std::size_t i = 0; i < phenotype.organs.size(); ++i) {
        const GrownOrgan& organ = phenotype.organs[i];
        const auto before = std::count_if(
            phenotype.organs.begin(), phenotype.organs.begin() + static_cast<std::ptrdiff_t>(i),
            [&](const GrownOrgan& each) {
                return each.part == organ.part && each.place == organ.place;
            });
        const Vec3& half = phenotype.plan.parts[organ.part].half_extents;
        const double size = std::min(kMostSize, kSizeShare * std::min(half.x(), half.y()));
        if (size < kLeastPixels * pixel) continue;
        const double x =
            kInside * organ.place * half.x() + 2.2 * size * static_cast<double>(before);
        const Pose& pose = poses[organ.part];
        if (organ.mark == OrganMark::kArcs) {
            add_arcs(frame, pose, x, size, pixel);
        } else {
            add_dots(frame, pose, x, size);
        }
    }
}

}  // namespace cambrian
