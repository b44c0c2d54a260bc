#include "pictures/scene/follow_camera.h"

#include "math/elementary.h"
#include "pictures/scene/shaped_ground.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kHorizonShare = 0.24;  // share of the viewport's height that is below the ground

// The distance from a part's centre to its corners, or more if the part deforms.
double widest_reach(const PlannedPart& part) {
    const Vec2 half = part.half_extents.head<2>();
    if (!part.stretch) return half.norm();
    return Vec2(half.x() * exponential(part.stretch->high),
                half.y() * exponential(-part.stretch->low))
        .norm();
}

}  // namespace

WorldWindow body_window(const Phenotype& phenotype, std::span<const Pose> poses) {
    WorldWindow window{Vec2::Constant(1e9), Vec2::Constant(-1e9)};
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const double reach = widest_reach(phenotype.plan.parts[i]);
        const Vec2 at = poses[i].position.head<2>();
        window.low = window.low.cwiseMin(at - Vec2::Constant(reach));
        window.high = window.high.cwiseMax(at + Vec2::Constant(reach));
    }
    return window;
}

Vec2 follow_center(const Vec2& center_of_mass, const Environment& environment, const Camera& camera,
                   const Viewport& viewport) {
    if (!environment.has_ground) return center_of_mass;
    const double height = viewport.height * camera.pixel();
    const double level = (0.5 - kHorizonShare) * height;
    if (environment.terrain.is_flat())
        return {center_of_mass.x(), std::max(level, center_of_mass.y() - 0.2 * height)};
    const double land = level + land_level(environment, center_of_mass.x());
    return {center_of_mass.x(), std::clamp(land, center_of_mass.y() - 0.2 * height,
                                           center_of_mass.y() + 0.35 * height)};
}

}  // namespace cambrian
