#include "pictures/scene/space_world.h"

#include "core/hash.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cambrian {
namespace {

constexpr double kSeabed = 2.2;         // m below creatures that swim, at least
constexpr double kSpeckSpacing = 0.55;  // m; one speck in each cube of the water
constexpr int kSpeckCubes = 6;          // to each side of the creature
constexpr double kSpeckSize = 0.006;    // m

// A number in [0, 1) that belongs to a cube of the water.
double cube_number(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t salt) {
    Hash64 hash;
    for (const std::int64_t number : {x, y, z})
        hash.add(static_cast<std::uint64_t>(number));
    hash.add(salt);
    return static_cast<double>(hash.value() >> 11U) * 0x1p-53;
}

Color squared_up(const Color& color, float factor) {
    return {color.r * factor, color.g * factor, color.b * factor, 1.0F};
}

void use_water(SpaceFrame& frame, const DrawnWorld& world, const SpaceLook& look) {
    SpaceLight& light = frame.light;
    light.around = {mix(world.recipe.sky[0], world.recipe.sky[1], 0.35F), world.recipe.sky[2],
                    mix(world.recipe.ridges[2][1], world.recipe.sky[0], 0.25F)};
    light.direction = {-0.22, 0.93, 0.30};
    light.key = {0.92F, 0.97F, 0.90F};
    light.above = color_of(0xD4EFF0);
    light.below = color_of(0x3C7382);
    const double distance = frame.camera.distance();
    light.haze_from = 1.2 * distance;
    light.haze_depth = 2.4 * distance;
    light.dimness = 0.75;
    // The floor of the sea keeps away from those who dive: it is scenery, and no ground.
    SpaceFloor floor;
    floor.height = std::min(-kSeabed, frame.camera.target.y() - kSeabed);
    floor.color = mix(color_of(0xCDBf98), world.recipe.sky[0], 0.55F);
    floor.grain = 0.35F;
    floor.ripples = 0.30F;
    floor.time = look.time;
    floor.shade = 0.5F;
    if (look.grid) floor.lines = color_of(0xFFFFFF, 0.16F);
    frame.floor = floor;
    add_hanging_specks(frame, world.specks.a > 0.0F ? world.specks : color_of(0xB5E3E0, 0.35F));
}

void use_land(SpaceFrame& frame, const DrawnWorld& world, const SpaceLook& look, bool has_ground) {
    SpaceLight& light = frame.light;
    const BackdropRecipe& recipe = world.recipe;
    light.around = {recipe.sky[0], recipe.sky[2],
                    has_ground ? recipe.sky[0] : mix(recipe.sky[0], recipe.sky[1], 0.5F)};
    light.around[1] = mix(recipe.sky[1], recipe.sky[2], 0.6F);
    light.key = squared_up(world.light.key, 0.95F);
    light.above = squared_up(world.light.fill, 1.35F);
    light.below = mix(recipe.ground[1], world.light.fill, 0.4F);
    const double distance = frame.camera.distance();
    light.haze_from = 3.0 * distance;
    light.haze_depth = 9.0 * distance;
    light.dimness = 0.85;
    if (!has_ground) return add_hanging_specks(frame, color_of(0xFFFFFF, 0.5F));
    SpaceFloor floor;
    floor.color = mix(recipe.ground[0], recipe.ground[1], 0.22F);
    floor.grain = 0.28F;
    floor.lines =
        with_alpha(mix(recipe.ground[0], color_of(0x000000), 0.45F), look.grid ? 0.7F : 0.4F);
    frame.floor = floor;
}

// A plain background, in the colours of the window.
void use_nothing(SpaceFrame& frame, const Palette& palette, bool has_ground, bool grid) {
    SpaceLight& light = frame.light;
    light.around = {mix(palette.sky, palette.faint, 0.12F), mix(palette.sky, palette.faint, 0.03F),
                    palette.sky};
    light.above = color_of(0xD8DEE6);
    light.below = color_of(0x6A655F);
    const double distance = frame.camera.distance();
    light.haze_from = 1.6 * distance;
    light.haze_depth = 4.0 * distance;
    SpaceFloor floor;
    if (!has_ground) floor.height = std::min(-kSeabed, frame.camera.target.y() - kSeabed);
    floor.color = has_ground ? palette.ground : mix(palette.sky, palette.faint, 0.05F);
    floor.lines = with_alpha(palette.faint, grid ? 0.45F : 0.0F);
    floor.shade = has_ground ? 0.6F : 0.35F;
    frame.floor = floor;
}

}  // namespace

void add_hanging_specks(SpaceFrame& frame, const Color& color) {
    const SpaceCamera& camera = frame.camera;
    // Specks stay as far apart in the picture however far away the camera is.
    double spacing = kSpeckSpacing;
    while (spacing < 0.11 * camera.distance())
        spacing *= 2.0;
    const auto cube_of = [spacing](double place) {
        return static_cast<std::int64_t>(std::floor(place / spacing));
    };
    const std::int64_t at[3] = {cube_of(camera.target.x()), cube_of(camera.target.y()),
                                cube_of(camera.target.z())};
    for (std::int64_t i = at[0] - kSpeckCubes; i <= at[0] + kSpeckCubes; ++i) {
        for (std::int64_t j = at[1] - kSpeckCubes; j <= at[1] + kSpeckCubes; ++j) {
            for (std::int64_t k = at[2] - kSpeckCubes; k <= at[2] + kSpeckCubes; ++k) {
                const Vec3 inside(cube_number(i, j, k, 1), cube_number(i, j, k, 2),
                                  cube_number(i, j, k, 3));
                const Vec3 corner(static_cast<double>(i), static_cast<double>(j),
                                  static_cast<double>(k));
                SpaceMark speck;
                speck.place = spacing * (corner + inside);
                const SpaceCamera::Seen seen = camera.look_at(speck.place);
                const double depth = seen.distance / camera.distance();
                const bool shown = depth > 0.4 && seen.place.x() > -9.0 && seen.place.y() > -9.0 &&
                                   seen.place.x() < camera.width + 9.0 &&
                                   seen.place.y() < camera.height + 9.0;
                const double faint = std::clamp(1.8 - depth, 0.0, 1.0);
                if (!shown || faint <= 0.0) continue;
                speck.radius =
                    kSpeckSize * spacing / kSpeckSpacing * (0.5 + cube_number(i, j, k, 4));
                speck.least = 0.8;
                speck.softness = 0.8F;
                speck.color = with_alpha(color, color.a * static_cast<float>(faint) * 1.6F);
                frame.marks.push_back(speck);
            }
        }
    }
}

void use_space(SpaceFrame& frame, const Environment& environment, const SpaceLook& look) {
    if (look.plain != nullptr)
        return use_nothing(frame, *look.plain, environment.has_ground, look.grid);
    const WorldKind kind = world_kind_of(environment);
    const DrawnWorld& world = drawn_world(kind, look.daytime);
    if (kind == WorldKind::kWater || kind == WorldKind::kNightSea)
        return use_water(frame, world, look);
    use_land(frame, world, look, environment.has_ground);
}

}  // namespace cambrian
