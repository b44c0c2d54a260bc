#include "pictures/scene/worlds.h"

#include <array>
#include <cstdint>

namespace cambrian {
namespace {

constexpr double kWaterDrag = 0.5;        // kg/m^2, quadratic; the swimmers' is 1
constexpr double kThickDrag = 1.0;        // N s/m^2, linear, in which a body swims as well
constexpr double kSpaceDensity = 1000.0;  // of what settings in space have for 1 in the plane
constexpr double kFaintGravity = 3.0;     // m/s^2
constexpr double kIceFriction = 0.2;      // coefficient

using Colors3 = std::array<std::uint32_t, 3>;
using Colors4 = std::array<std::uint32_t, 4>;
using Ridges = std::array<std::array<std::uint32_t, 2>, 3>;

void paint_sky(BackdropRecipe& recipe, const Colors3& from_horizon) {
    for (std::size_t i = 0; i < from_horizon.size(); ++i)
        recipe.sky[i] = color_of(from_horizon[i]);
}

void paint_ridges(BackdropRecipe& recipe, RidgeForm form, const Ridges& far_to_near) {
    recipe.form = form;
    for (std::size_t i = 0; i < far_to_near.size(); ++i)
        recipe.ridges[i] = {color_of(far_to_near[i][0]), color_of(far_to_near[i][1])};
}

void paint_ground(BackdropRecipe& recipe, SoilForm soil, const Colors4& down) {
    recipe.has_ground = true;
    recipe.soil = soil;
    for (std::size_t i = 0; i < down.size(); ++i)
        recipe.ground[i] = color_of(down[i]);
}

void place_body(BackdropRecipe& recipe, HeavenlyBody body, std::uint32_t color, const Vec2& place,
                double radius) {
    recipe.body = body;
    recipe.body_color = color_of(color);
    recipe.body_place = place;
    recipe.body_radius = radius;
}

DrawnWorld meadow_at_noon() {
    DrawnWorld world;
    world.kind = WorldKind::kMeadow;
    paint_sky(world.recipe, {0xF4DDBA, 0xA9CBE6, 0x4C8ED0});
    place_body(world.recipe, HeavenlyBody::kSun, 0xFFF3CE, {0.80, 0.76}, 0.055);
    world.recipe.clouds = 1.0F;
    paint_ridges(world.recipe, RidgeForm::kHills,
                 {{{0xA9B7D2, 0xC9CCD9}, {0x84A9A6, 0xA9C4B0}, {0x5C9468, 0x7FAE72}}});
    paint_ground(world.recipe, SoilForm::kTurf, {0x5E9A3C, 0x8A5F3C, 0x3C2A22, 0xA89072});
    world.light.sun = {0.42, 0.66, 0.62};
    world.light.key = {0.86F, 0.80F, 0.70F};
    world.light.fill = {0.56F, 0.57F, 0.60F};
    world.light.rim = {0.55F, 0.48F, 0.36F};
    world.light.ink = {0.20F, 0.17F, 0.20F};
    world.grass = color_of(0x5E9A3C);
    world.words = color_of(0xFFFFFF);
    return world;
}

DrawnWorld meadow_by_day() {
    DrawnWorld world = meadow_at_noon();
    paint_sky(world.recipe, {0xFDF6EA, 0xE0EDF7, 0xB0D2EE});
    place_body(world.recipe, HeavenlyBody::kSun, 0xFFFDF2, {0.80, 0.76}, 0.05);
    paint_ridges(world.recipe, RidgeForm::kHills,
                 {{{0xD7E0EC, 0xEAEDF2}, {0xC2D8D4, 0xDCE8DE}, {0xA5CDA6, 0xC6E0BC}}});
    paint_ground(world.recipe, SoilForm::kTurf, {0x86BF62, 0xD9BF9F, 0xB9977A, 0xEADBC5});
    world.light.key = {0.74F, 0.70F, 0.62F};
    world.light.fill = {0.56F, 0.58F, 0.62F};
    world.light.ink = {0.28F, 0.23F, 0.26F};
    world.grass = color_of(0x7DB85A);
    world.words = color_of(0x4A3A2C);
    return world;
}

DrawnWorld meadow_at_dusk() {
    DrawnWorld world = meadow_at_noon();
    paint_sky(world.recipe, {0xC0705A, 0x4C3F66, 0x141A33});
    place_body(world.recipe, HeavenlyBody::kCrescent, 0xF5EBD2, {0.82, 0.80}, 0.042);
    world.recipe.clouds = 0.0F;
    world.recipe.stars = 0.8F;
    paint_ridges(world.recipe, RidgeForm::kHills,
                 {{{0x5A4766, 0x6E4E66}, {0x3A3552, 0x45395A}, {0x23303C, 0x2A3A40}}});
    paint_ground(world.recipe, SoilForm::kTurf, {0x2F4A33, 0x35281F, 0x17120F, 0x55493C});
    world.light.sun = {-0.35, 0.45, 0.62};
    world.light.key = {0.80F, 0.62F, 0.52F};
    world.light.fill = {0.44F, 0.42F, 0.52F};
    world.light.rim = {0.75F, 0.45F, 0.32F};
    world.light.ink = {0.10F, 0.08F, 0.11F};
    world.grass = color_of(0x34533A);
    world.words = color_of(0xE8DCD0);
    return world;
}

DrawnWorld moon() {
    DrawnWorld world = meadow_at_noon();
    world.kind = WorldKind::kMoon;
    paint_sky(world.recipe, {0x0B0D12, 0x05060A, 0x020308});
    place_body(world.recipe, HeavenlyBody::kEarth, 0x3A78C8, {0.79, 0.72}, 0.08);
    world.recipe.clouds = 0.0F;
    world.recipe.stars = 1.0F;
    paint_ridges(world.recipe, RidgeForm::kDunes,
                 {{{0x3A3C42, 0x4A4B50}, {0x57585C, 0x6B6B6D}, {0x77767A, 0x8C8A88}}});
    paint_ground(world.recipe, SoilForm::kRegolith, {0xC9C6C0, 0x9A9792, 0x4A4846, 0xE8E5E0});
    world.light.sun = {-0.62, 0.60, 0.50};
    world.light.key = {1.05F, 1.00F, 0.94F};
    world.light.fill = {0.28F, 0.29F, 0.34F};
    world.light.rim = {0.40F, 0.42F, 0.50F};
    world.light.ink = {0.10F, 0.10F, 0.12F};
    world.grass = {0.0F, 0.0F, 0.0F, 0.0F};
    world.words = color_of(0x1A1A1C);
    return world;
}

DrawnWorld ice() {
    DrawnWorld world = meadow_at_noon();
    world.kind = WorldKind::kIce;
    paint_sky(world.recipe, {0xE9F3F7, 0xB6DAEA, 0x6FB1D6});
    place_body(world.recipe, HeavenlyBody::kSun, 0xFFFCEC, {0.22, 0.68}, 0.045);
    world.recipe.clouds = 0.5F;
    paint_ridges(world.recipe, RidgeForm::kBergs,
                 {{{0xBFD9E8, 0xDCEBF2}, {0x9CC6DC, 0xC8E2EE}, {0xD8ECF4, 0xF2F9FC}}});
    paint_ground(world.recipe, SoilForm::kIce, {0xFFFFFF, 0xA9D8EA, 0x2F7FA8, 0xFFFFFF});
    world.light.sun = {-0.45, 0.66, 0.60};
    world.light.key = {0.74F, 0.76F, 0.74F};
    world.light.fill = {0.52F, 0.58F, 0.64F};
    world.light.rim = {0.50F, 0.58F, 0.62F};
    world.light.ink = {0.22F, 0.24F, 0.30F};
    world.grass = {0.0F, 0.0F, 0.0F, 0.0F};
    world.specks = color_of(0xFFFFFF, 0.8F);
    world.words = color_of(0x0F3A52);
    return world;
}

DrawnWorld water_world() {
    DrawnWorld world;
    world.kind = WorldKind::kWater;
    paint_sky(world.recipe, {0x052338, 0x0E5670, 0x3FB2B6});
    world.recipe.shafts = 1.0F;
    paint_ridges(world.recipe, RidgeForm::kSeabed,
                 {{{0x0F5068, 0x0A3A52}, {0x0B3F56, 0x072C42}, {0x062C40, 0x042032}}});
    world.recipe.has_ground = false;
    world.light.sun = {0.20, 0.85, 0.50};
    world.light.key = {0.72F, 0.84F, 0.80F};
    world.light.fill = {0.36F, 0.52F, 0.58F};
    world.light.rim = {0.38F, 0.62F, 0.60F};
    world.light.ink = {0.08F, 0.12F, 0.16F};
    world.specks = color_of(0xB5E3E0, 0.35F);
    world.words = color_of(0xD8FFFA);
    return world;
}

DrawnWorld seabed() {
    DrawnWorld world = water_world();
    world.kind = WorldKind::kSeabed;
    paint_ground(world.recipe, SoilForm::kSand, {0xB9A778, 0x8A7C5C, 0x2A2E34, 0xC8B890});
    return world;
}

DrawnWorld air() {
    DrawnWorld world = meadow_at_noon();
    world.kind = WorldKind::kAir;
    paint_sky(world.recipe, {0xCFE6F4, 0x86BDE8, 0x2F78C4});
    place_body(world.recipe, HeavenlyBody::kSun, 0xFFF8DC, {0.76, 0.74}, 0.055);
    world.recipe.clouds = 0.8F;
    paint_ridges(world.recipe, RidgeForm::kClouds,
                 {{{0xDCEAF5, 0xF4F8FB}, {0xE9F1F8, 0xFFFFFF}, {0xF6FAFD, 0xFFFFFF}}});
    world.recipe.has_ground = false;
    world.light.sun = {0.45, 0.70, 0.58};
    world.light.fill = {0.50F, 0.54F, 0.60F};
    world.grass = {0.0F, 0.0F, 0.0F, 0.0F};
    return world;
}

DrawnWorld night() {
    DrawnWorld world = meadow_at_dusk();
    world.kind = WorldKind::kNight;
    paint_sky(world.recipe, {0x1A2A44, 0x0E1730, 0x060A18});
    place_body(world.recipe, HeavenlyBody::kCrescent, 0xE8ECF4, {0.13, 0.80}, 0.036);
    world.recipe.stars = 1.0F;
    paint_ridges(world.recipe, RidgeForm::kHills,
                 {{{0x16233C, 0x1B2A44}, {0x111B2E, 0x152238}, {0x0C1522, 0x101B2A}}});
    paint_ground(world.recipe, SoilForm::kTurf, {0x22382E, 0x241D18, 0x0E0B0A, 0x3A332C});
    world.light.sun = {-0.50, 0.60, 0.60};
    world.light.key = {0.26F, 0.32F, 0.44F};
    world.light.fill = {0.34F, 0.37F, 0.46F};
    world.light.rim = {0.22F, 0.30F, 0.45F};
    world.light.ink = {0.08F, 0.08F, 0.10F};
    world.grass = color_of(0x27402F);
    world.words = color_of(0xC8D0E0);
    return world;
}

DrawnWorld night_sea() {
    DrawnWorld world = water_world();
    world.kind = WorldKind::kNightSea;
    paint_sky(world.recipe, {0x020B16, 0x05202F, 0x0C4354});
    world.recipe.shafts = 0.35F;
    paint_ridges(world.recipe, RidgeForm::kSeabed,
                 {{{0x07283A, 0x041B2A}, {0x051D2C, 0x031420}, {0x03131E, 0x020C15}}});
    world.light.key = {0.25F, 0.34F, 0.36F};
    world.light.fill = {0.36F, 0.44F, 0.48F};
    world.light.rim = {0.16F, 0.30F, 0.34F};
    return world;
}

DrawnWorld night_sky() {
    DrawnWorld world = night();
    world.kind = WorldKind::kNightSky;
    paint_ridges(world.recipe, RidgeForm::kClouds,
                 {{{0x1E2B44, 0x16233C}, {0x24324C, 0x1B2A44}, {0x2A3A56, 0x223048}}});
    world.recipe.has_ground = false;
    world.grass = {0.0F, 0.0F, 0.0F, 0.0F};
    return world;
}

}  // namespace

WorldKind world_kind_of(const Environment& environment) {
    const double scale = environment.dimensions == 3 ? kSpaceDensity : 1.0;
    const bool drags = environment.viscosity_quadratic >= scale * kWaterDrag ||
                       environment.viscosity_linear >= scale * kThickDrag;
    if (environment.has_light) {
        if (environment.has_ground) return WorldKind::kNight;
        return drags ? WorldKind::kNightSea : WorldKind::kNightSky;
    }
    if (drags) return environment.has_ground ? WorldKind::kSeabed : WorldKind::kWater;
    if (!environment.has_ground) return WorldKind::kAir;
    if (environment.gravity < kFaintGravity) return WorldKind::kMoon;
    return environment.friction < kIceFriction ? WorldKind::kIce : WorldKind::kMeadow;
}

const DrawnWorld& drawn_world(WorldKind kind, Daytime daytime) {
    static const std::array<DrawnWorld, 3> kMeadows = {meadow_at_noon(), meadow_by_day(),
                                                       meadow_at_dusk()};
    static const DrawnWorld kIceWorld = ice();
    static const DrawnWorld kMoonWorld = moon();
    static const DrawnWorld kWaterWorld = water_world();
    static const DrawnWorld kSeabedWorld = seabed();
    static const DrawnWorld kAirWorld = air();
    static const DrawnWorld kNightWorld = night();
    static const DrawnWorld kNightSeaWorld = night_sea();
    static const DrawnWorld kNightSkyWorld = night_sky();
    switch (kind) {
        case WorldKind::kMeadow:
            break;
        case WorldKind::kIce:
            return kIceWorld;
        case WorldKind::kMoon:
            return kMoonWorld;
        case WorldKind::kWater:
            return kWaterWorld;
        case WorldKind::kSeabed:
            return kSeabedWorld;
        case WorldKind::kAir:
            return kAirWorld;
        case WorldKind::kNight:
            return kNightWorld;
        case WorldKind::kNightSea:
            return kNightSeaWorld;
        case WorldKind::kNightSky:
            return kNightSkyWorld;
    }
    return kMeadows[static_cast<std::size_t>(daytime)];
}

const Palette& palette_over(const DrawnWorld& world) {
    static const Palette kOnDark = palette_of(ThemeKind::kDark);
    static const Palette kOnLight = palette_of(ThemeKind::kLight);
    const Color& sky = world.recipe.sky[2];
    const float lightness = 0.30F * sky.r + 0.59F * sky.g + 0.11F * sky.b;
    return lightness < 0.6F ? kOnDark : kOnLight;
}

void use_world(SceneFrame& frame, const DrawnWorld& world) {
    frame.background = world.recipe.sky[1];
    frame.backdrop = &world.recipe;
    frame.light = world.light;
}

}  // namespace cambrian
