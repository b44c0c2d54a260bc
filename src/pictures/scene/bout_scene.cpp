#include "pictures/scene/bout_scene.h"

#include "pictures/scene/follow_camera.h"
#include "pictures/scene/living_look.h"
#include "simulator/contest/bout.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

const Color kCubeColor = color_of(0xC9A26B);
const Color kCubeEdge = color_of(0x6E5330);
constexpr double kLeastHueDistance = 0.12;  // turns

}  // namespace

double apart_from(double hue, double opponent) {
    const double apart = std::abs(hue - opponent);
    const bool alike = std::min(apart, 1.0 - apart) < kLeastHueDistance;
    const double shown = alike ? hue + 0.5 : opponent;
    return shown - std::floor(shown);
}

WorldWindow with_bout(const WorldWindow& body, const BoutLook& look) {
    const Vec2 corner = Vec2::Constant(kHalfCube * std::sqrt(2.0));
    const Vec2 cube = look.cube.position.head<2>();
    WorldWindow window{body.low.cwiseMin(cube - corner), body.high.cwiseMax(cube + corner)};
    if (look.opponent == nullptr) return window;
    const WorldWindow opponent = body_window(*look.opponent, look.poses);
    return {window.low.cwiseMin(opponent.low), window.high.cwiseMax(opponent.high)};
}

void add_bout(SceneFrame& frame, const Palette& palette, const Camera& camera,
              const BoutLook& look) {
    Shape cube;
    cube.center = look.cube.position.head<2>();
    cube.half_extents = Vec2::Constant(kHalfCube);
    cube.angle = planar_angle(look.cube);
    cube.outline_width = std::max(1.5 * camera.pixel(), 0.012);
    cube.fill = kCubeColor;
    cube.outline = kCubeEdge;
    frame.shapes.push_back(cube);
    if (look.opponent == nullptr) return;
    const double hue = apart_from(look.beside, look.hue);
    CreatureLook opponent{*look.opponent, look.poses, {}, hue, {}, look.stretches, look.mode};
    opponent.character.line = line_or_hue(0, look.hue);
    opponent.character.time = look.time;
    // It faces the cube.
    const Vec2 cube_at = look.cube.position.head<2>();
    const Vec2 root = look.poses.front().position.head<2>();
    opponent.character.way = way_of(cube_at - root, true);
    look_at(opponent.character, root, cube_at);
    add_shadow(frame, opponent);
    add_being(frame, palette, camera, opponent);
}

}  // namespace cambrian
