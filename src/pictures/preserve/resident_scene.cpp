#include "pictures/preserve/resident_scene.h"

#include "math/elementary.h"
#include "math/pose.h"
#include "pictures/scene/living_look.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cambrian {
namespace {

// Scales from which bodies have skins, eyes and organs, in pixels per metre.
constexpr double kDetailScale = 22.0;
constexpr double kLightDetailScale = 45.0;  // in light frames
constexpr double kBirthShown = 0.9;         // s for which a birth is seen
constexpr double kBiteShown = 0.35;         // s for which the beginning of a bite is seen
constexpr double kMealShown = 0.15;         // s for which a mouth stays open
const Color kHatchColor = color_of(0xFFF1C4);

double angle_of(const Rectangle& part) {
    return std::atan2(part.axis.y(), part.axis.x());
}

Character character_in(const ResidentPicture& resident, const ShownWorld& world) {
    constexpr double kTelling = 0.3;  // body sizes from its birthplace, which tell its way
    Character character;
    character.line = resident.life.lineage;
    character.walks = world.area.has_ground;
    character.time = world.time() + static_cast<double>(resident.life.number % 7) * 0.5;
    const double size = body_size(*resident.phenotype);
    const Vec3 born(resident.life.x, resident.life.y, 0.0);
    const double gone = world.area.torus().shortest(resident.center - born).x();
    if (character.walks && gone < -kTelling * size) character.way = {-1.0, 0.0};
    look_along(character, resident.velocity.head<2>(), size);
    return character;
}

void add_simple_body(SceneFrame& frame, const Palette& palette, const Camera& camera,
                     const ResidentPicture& resident, double hue) {
    for (std::size_t i = resident.parts.size(); i-- > 0;) {
        Shape shape = shape_of(resident.parts[i]);
        shape.outline_width = std::max(camera.pixel(), 0.008);
        shape.fill = part_color(resident.phenotype->parts[i], hue);
        shape.outline =
            resident.bitten ? palette.danger : mix(shape.fill, color_of(0x000000), 0.38F);
        frame.shapes.push_back(shape);
    }
}

// Draws a body as a dark shape with a coloured inside, the cheapest picture of one skin.
void add_small_body(SceneFrame& frame, const Palette& palette, const Camera& camera,
                    const ResidentPicture& resident, double hue) {
    for (const bool inside : {false, true}) {
        for (std::size_t i = resident.parts.size(); i-- > 0;) {
            Shape shape = shape_of(resident.parts[i]);
            const Color color =
                skin_color(resident.phenotype->parts[i], hue, resident.life.lineage);
            const double grown = (inside ? -0.5 : 0.7) * camera.pixel();
            shape.half_extents = (shape.half_extents + Vec2::Constant(grown))
                                     .cwiseMax(Vec2::Constant(0.45 * camera.pixel()));
            shape.radius = 0.62 * shape.half_extents.minCoeff();
            shape.fill = inside            ? color
                         : resident.bitten ? palette.danger
                                           : mix(color, color_of(0x100A0C), 0.78F);
            frame.shapes.push_back(shape);
        }
    }
}

// A ring grows where a bite begins. Boxes have a red outline as long as it lasts; a skin has its
// own.
void add_bite(SceneFrame& frame, const Palette& palette, const Camera& camera,
              const ResidentPicture& resident, const ShownWorld& world) {
    const double age = world.seconds_since(resident.bitten_since) / kBiteShown;
    if (age < 1.0) {
        frame.add_ring(resident.center.head<2>(), (0.4 + 0.7 * age) * reach_of(resident),
                       2.0 * camera.pixel(),
                       with_alpha(palette.danger, static_cast<float>(0.9 * (1.0 - age))));
    }
    if (world.mode == LookMode::kLife) return;
    for (const Rectangle& part : resident.parts) {
        Shape shape = shape_of(part);
        shape.outline_width = 2.0 * camera.pixel();
        shape.fill = with_alpha(palette.danger, 0.0F);
        shape.outline = palette.danger;
        frame.shapes.push_back(shape);
    }
}

void add_detailed_body(SceneFrame& frame, const Palette& palette, const Camera& camera,
                       const ResidentPicture& resident, double hue, const ShownWorld& world) {
    std::vector<Pose> poses;
    std::vector<double> stretches;
    for (std::size_t i = 0; i < resident.parts.size(); ++i) {
        const Rectangle& part = resident.parts[i];
        poses.push_back(planar_pose(part.center.x(), part.center.y(), angle_of(part)));
        const double rest = resident.phenotype->plan.parts[i].half_extents.x();
        stretches.push_back(std::log(part.half_length / rest));
    }
    CreatureLook look{
        .phenotype = *resident.phenotype, .poses = poses, .hue = hue, .stretches = stretches};
    look.mode = world.mode;
    look.bitten = resident.bitten;
    look.bites = resident.fed != 0 && world.seconds_since(resident.fed) < kMealShown;
    look.character = character_in(resident, world);
    add_being(frame, palette, camera, look);
    if (resident.bitten) add_bite(frame, palette, camera, resident, world);
}

// Where a creature was born, a ring and shards of a shell fly apart.
void add_birth(SceneFrame& frame, const Camera& camera, const ResidentPicture& resident,
               const ShownWorld& world) {
    constexpr int kShards = 7;
    const double age = world.seconds_since(resident.life.born) / kBirthShown;
    if (resident.life.born == 0 || age >= 1.0) return;
    const auto left = static_cast<float>((1.0 - age) * (1.0 - age));
    const Vec2 center = resident.center.head<2>();
    const double reach = std::max(reach_of(resident), 4.0 * camera.pixel());
    frame.add_glow(center, 1.9 * reach, with_alpha(kHatchColor, 0.5F * left));
    frame.add_ring(center, (0.7 + 0.8 * age) * reach, std::max(0.06 * reach, 1.2 * camera.pixel()),
                   with_alpha(kHatchColor, 0.9F * left));
    for (int i = 0; i < kShards; ++i) {
        const double turn = chance(resident.life.number, 60 + static_cast<std::uint64_t>(i));
        const auto [sine, cosine] = sine_cosine(2.0 * kPi * (i + 0.6 * turn) / kShards);
        frame.add_circle(center + (0.6 + (0.6 + turn) * age) * reach * Vec2(cosine, sine),
                         std::max(0.05 * reach, 0.9 * camera.pixel()),
                         with_alpha(kHatchColor, left));
    }
}

}  // namespace

void add_resident(SceneFrame& frame, const Palette& palette, const Camera& camera,
                  const ResidentPicture& resident, const ShownWorld& world) {
    const double hue = lineage_hue(resident.life.lineage);
    add_birth(frame, camera, resident, world);
    const double detail = frame.detail == Detail::kLight ? kLightDetailScale : kDetailScale;
    if (camera.pixels_per_metre >= detail) {
        add_detailed_body(frame, palette, camera, resident, hue, world);
    } else if (world.mode == LookMode::kMechanics) {
        add_simple_body(frame, palette, camera, resident, hue);
    } else {
        add_small_body(frame, palette, camera, resident, hue);
    }
}

double lineage_hue(std::uint64_t lineage) {
    const double turns = 0.61803398875 * static_cast<double>(lineage % 100'000);
    return turns - static_cast<double>(static_cast<std::uint64_t>(turns));
}

double reach_of(const ResidentPicture& resident) {
    double reach = 0.0;
    for (const Rectangle& part : resident.parts) {
        const double half = std::hypot(part.half_length, part.half_width);
        reach = std::max(reach, (part.center - resident.center).norm() + half);
    }
    return reach;
}

Shape shape_of(const Rectangle& part) {
    Shape shape;
    shape.center = part.center.head<2>();
    shape.half_extents = {part.half_length, part.half_width};
    shape.angle = angle_of(part);
    shape.radius = 0.45 * std::min(part.half_length, part.half_width);
    return shape;
}

}  // namespace cambrian
