#include "simulator/surroundings/side_wall.h"

#include "core/random.h"

#include <cstdint>
#include <limits>

namespace cambrian {
namespace {

constexpr std::uint64_t kWallStream = 104;  // separates its draws from those of other chance
constexpr double kHalfThickness = 0.15;     // m
constexpr double kFoundation = 0.2;         // m, below the ground

}  // namespace

SideWall draw_side_wall(const Environment& environment, const LightDraw& draw, const Bounds& body) {
    const auto pair = static_cast<std::uint64_t>(draw.trial / 2);
    RandomStream random(stream_seed({draw.seed, pair, kWallStream}));
    const double distance = random.uniform(environment.wall_nearest, environment.wall_farthest);
    SideWall wall;
    wall.side = random.chance(0.5) == (draw.trial % 2 == 0) ? 1 : -1;
    const double near = wall.side > 0 ? body.high.x() + distance : body.low.x() - distance;
    const double x = near + wall.side * kHalfThickness;
    const double half_height = 0.5 * (kWallHeight + kFoundation);
    wall.box.center = {x, kWallHeight - half_height, 0.0};
    wall.box.axis = Vec3::UnitX();
    wall.box.half_length = kHalfThickness;
    wall.box.half_width = half_height;
    wall.box.low = {x - kHalfThickness, -kFoundation, 0.0};
    wall.box.high = {x + kHalfThickness, kWallHeight, 0.0};
    return wall;
}

double distance_to_wall(const FixedBox& wall, const Vec3& point, int direction) {
    if (point.x() >= wall.low.x() && point.x() <= wall.high.x()) return 0.0;
    const double away = direction > 0 ? wall.low.x() - point.x() : point.x() - wall.high.x();
    return away > 0.0 ? away : std::numeric_limits<double>::infinity();
}

}  // namespace cambrian
