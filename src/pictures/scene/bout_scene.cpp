#include "pictures/scene/bout_scene.h"

#include "pictures/scene/scene_builder.h"
#include "simulator/contest/bout.h"

#include <algorithm>

namespace cambrian {
namespace {

const Color kCubeColor = color_of(0xC9A26B);
const Color kCubeEdge = color_of(0x6E5330);

}  // namespace

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
    const CreatureLook opponent{*look.opponent, look.poses, {}, look.hue, {}, look.stretches};
    add_shadow(frame, opponent);
    add_creature(frame, palette, camera, opponent);
}

}  // namespace cambrian
