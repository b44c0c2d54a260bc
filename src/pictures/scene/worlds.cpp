#include "pictures/scene/worlds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace cambrian {
namespace {

constexpr double kWaterDrag = 0.5;        // kg/m^2, quadratic; the swimmers' is 1
constexpr double kThickDrag = 1.0;        // N s/m^2, linear, in which a body swims as well
constexpr double kSpaceDensity = 1000.0;  // of what settings in space have for 1 in the plane
constexpr double kFaintGravity = 3.0;     // m/s^2
constexpr double kIceFriction = 0.2;      // coefficient
constexpr double kLeastBladePixels = 3.0;

// Returns a number in [0, 1) that follows from a place and a use.
double scattered(std::int64_t place, std::uint32_t use) {
    auto bits = static_cast<std::uint32_t>(place) * 0x9E3779B1U ^ use * 0x85EBCA77U;
    bits = (bits ^ (bits >> 15U)) * 0x2C1B3C6DU;
    bits = (bits ^ (bits >> 12U)) * 0x297A2D39U;
    return static_cast<double>((bits ^ (bits >> 15U)) >> 8U) / 16777216.0;
}

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

Vec2 size_of(const WorldWindow& window) {
    return window.high - window.low;
}

// The sun stays where it is in the view.
void add_sun(SceneFrame& frame, const BackdropRecipe& recipe, const WorldWindow& window) {
    if (recipe.body != HeavenlyBody::kSun) return;
    const Vec2 at = window.low + recipe.body_place.cwiseProduct(size_of(window));
    const double radius = recipe.body_radius * size_of(window).y();
    if (frame.detail == Detail::kFull)
        frame.add_glow(at, 3.2 * radius, with_alpha(recipe.body_color, 0.30F));
    frame.add_glow(at, 1.7 * radius, with_alpha(recipe.body_color, 0.45F));
    frame.add_circle(at, radius, recipe.body_color);
}

// A thin upright blade with its foot at a place; it leans by so many radians.
void add_blade(SceneFrame& frame, const Vec2& foot, double length, double width, double lean,
               const Color& color) {
    Shape blade;
    blade.center = foot + 0.5 * length * Vec2(-std::sin(lean), std::cos(lean));
    blade.half_extents = {0.5 * width, 0.5 * length};
    blade.angle = lean;
    blade.radius = 0.5 * width;
    blade.fill = color;
    frame.shapes.push_back(blade);
}

struct BladeRow {
    double spacing = 0.03;  // m
    double least = 0.03;    // m; length of the shortest
    double most = 0.12;     // m
    double foot = 0.0;      // m; height of their feet above the ground
    std::uint32_t use = 0;  // of scattered numbers
};

// Whether nothing grows at a place, since it is a wall or beside one.
bool is_steep(const GroundShape& ground, double x) {
    constexpr double kBeside = 0.02;   // m
    constexpr double kSteepest = 1.7;  // steepness
    if (ground.is_flat()) return false;
    return std::fabs(ground.at(x + kBeside) - ground.at(x - kBeside)) > 2.0 * kBeside * kSteepest;
}

void add_grass(SceneFrame& frame, const DrawnWorld& world, const Camera& camera,
               const Viewport& viewport, double time, const BladeRow& row) {
    const WorldWindow window = camera.window(viewport);
    if (world.grass.a <= 0.0F) return;
    if (frame.ground.is_flat() && (window.low.y() > row.most || window.high.y() < 0.0)) return;
    if (row.most * camera.pixels_per_metre < kLeastBladePixels) return;
    double spacing = row.spacing;
    while (spacing * camera.pixels_per_metre < 5.0)
        spacing *= 2.0;
    const double first = std::floor(window.low.x() / spacing) - 1.0;
    const double last = std::ceil(window.high.x() / spacing) + 1.0;
    for (double i = first; i <= last; i += 1.0) {
        const auto place = static_cast<std::int64_t>(i);
        if (frame.detail == Detail::kLight && place % 2 != 0) continue;
        const auto draw = [&](std::uint32_t use) { return scattered(place, row.use + use); };
        const double x = (i + 0.8 * (draw(1) - 0.5)) * spacing;
        if (is_steep(frame.ground, x)) continue;
        const double foot = frame.ground.at(x) + row.foot;
        const double tall = draw(2);
        const double length = row.least + (row.most - row.least) * tall * tall * draw(5);
        if (length * camera.pixels_per_metre < kLeastBladePixels) continue;
        const double lean =
            0.30 * (draw(3) - 0.5) + 0.06 * std::sin(1.7 * time + 2.2 * x + draw(4));
        const Color other = draw(6) < 0.5 ? color_of(0xE8E070) : color_of(0x103018);
        const Color color = mix(world.grass, other, 0.15F);
        const double width = std::max(1.6 * camera.pixel(), 0.007);
        add_blade(frame, {x, foot}, length, width, lean, color);
        if (row.use == 0 && draw(8) < 0.03) {
            const Color petals = draw(9) < 0.5 ? color_of(0xF2A65A) : color_of(0xF4EFE6);
            const Vec2 top(x - std::sin(lean) * length, foot + std::cos(lean) * length);
            frame.add_circle(top, std::max(1.6 * camera.pixel(), 0.011),
                             mix(world.grass, petals, 0.75F));
        }
    }
}

constexpr BladeRow kGrassBehind = {0.03, 0.035, 0.12, -0.008, 0};
constexpr BladeRow kGrassBefore = {0.065, 0.03, 0.065, -0.03, 100};

// Specks of plankton or snow and, in water, bubbles. Each moves in a window that repeats.
void add_specks(SceneFrame& frame, const DrawnWorld& world, const Camera& camera,
                const Viewport& viewport, double time) {
    if (world.specks.a <= 0.0F) return;
    constexpr int kSpecks = 46;
    const bool snow = world.kind == WorldKind::kIce;
    const WorldWindow window = camera.window(viewport);
    const Vec2 size = 1.2 * size_of(window);
    for (int i = 0; i < (frame.detail == Detail::kFull ? kSpecks : kSpecks / 2); ++i) {
        const auto draw = [i](std::uint32_t use) { return scattered(i, 200 + use); };
        const double depth = 0.35 + 0.65 * draw(1);
        const bool bubble = !snow && draw(6) < 0.18;
        const double rise = snow ? -0.35 * depth : bubble ? 0.25 : 0.04;
        const Vec2 drift(0.15 * (draw(5) - 0.5) * time, rise * time);
        Vec2 at = 4.0 * Vec2(draw(2), draw(3)).cwiseProduct(size) + drift - depth * camera.center;
        at -= at.cwiseQuotient(size).array().floor().matrix().cwiseProduct(size);
        at += window.low - 0.1 * size_of(window);
        if (world.recipe.has_ground && at.y() < frame.ground.at(at.x()) + 0.02) continue;
        const double unit = depth * camera.pixel() * viewport.height / 720.0;
        if (bubble) {
            const double radius = (2.5 + 5.0 * draw(4)) * unit;
            frame.add_ring(at, radius, 1.2 * unit,
                           color_of(0xD8FFFA, 0.4F * world.specks.a / 0.35F));
            frame.add_circle(at + radius * Vec2(-0.3, 0.35), 0.25 * radius,
                             color_of(0xFFFFFF, 0.6F));
        } else {
            const double radius = (snow ? 1.4 + 1.8 * draw(4) : 0.8 + 1.3 * draw(4)) * unit;
            frame.add_glow(at, 2.0 * radius,
                           with_alpha(world.specks, world.specks.a * static_cast<float>(depth)));
        }
    }
}

// A leaf that bends and tapers, of this many straight pieces.
void add_frond(SceneFrame& frame, const Vec2& foot, double length, double width, double lean,
               int pieces, const Color& color) {
    Vec2 from = foot;
    const double step = length / pieces;
    for (int i = 0; i < pieces; ++i) {
        const double share = static_cast<double>(i) / pieces;
        const double turned = lean * (0.4 + 1.4 * share);
        const Vec2 along(-std::sin(turned), std::cos(turned));
        const double wide = width * (1.0 - 0.75 * share);
        // Pieces reach into each other, so that joints are round.
        add_blade(frame, from - 0.5 * wide * along, step + wide, wide, turned, color);
        from += step * along;
    }
}

// Tufts of weed at the lower edge of the view, in two distances.
void add_weeds(SceneFrame& frame, const DrawnWorld& world, const Camera& camera,
               const Viewport& viewport, double time) {
    if (world.recipe.form != RidgeForm::kSeabed || world.recipe.has_ground) return;
    const WorldWindow window = camera.window(viewport);
    const Vec2 size = size_of(window);
    constexpr int kTufts = 9;
    const int leaves = frame.detail == Detail::kFull ? 6 : 4;
    const int pieces = frame.detail == Detail::kFull ? 5 : 3;
    for (int tuft = 0; tuft < kTufts; ++tuft) {
        const bool far = tuft < 5;
        const double width = 1.4 * size.x();
        double x = scattered(tuft, 301) * width - camera.center.x() * (far ? 0.30 : 0.45);
        x -= std::floor(x / width) * width + 0.2 * size.x();
        const Color base = mix(world.recipe.ridges[far ? 1 : 2][0], color_of(0x1E7A5E),
                               0.25F + 0.2F * static_cast<float>(scattered(tuft, 306)));
        for (int leaf = 0; leaf < leaves; ++leaf) {
            const std::int64_t which = 16 * tuft + leaf;
            const double length =
                (0.10 + 0.20 * scattered(which, 302) * scattered(tuft, 303)) * size.y();
            const double lean = 0.60 * (scattered(which, 304) - 0.5) +
                                0.16 * std::sin(0.7 * time + tuft + 0.5 * leaf);
            const double away = (scattered(which, 305) - 0.5) * 0.07 * size.y();
            const double thick = (0.010 + 0.008 * scattered(which, 307)) * size.y();
            const Color color =
                mix(base, world.recipe.sky[0], 0.25F * static_cast<float>(scattered(which, 308)));
            add_frond(frame, window.low + Vec2(x + away, -0.02 * size.y()), length, thick, lean,
                      pieces, color);
        }
    }
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

void add_scenery(SceneFrame& frame, const DrawnWorld& world, const Camera& camera,
                 const Viewport& viewport, double time) {
    use_world(frame, world);
    add_sun(frame, world.recipe, camera.window(viewport));
    add_weeds(frame, world, camera, viewport, time);
    add_specks(frame, world, camera, viewport, time);
    add_grass(frame, world, camera, viewport, time, kGrassBehind);
}

void add_lamp(SceneFrame& frame, const Camera& camera, const Viewport& viewport, const Vec2& place,
              double reach) {
    frame.light.lamp = place;
    frame.light.lamp_reach = reach;
    frame.light.lamp_power = 1.0F;
    const double high = size_of(camera.window(viewport)).y();
    const Color glow = color_of(0xFFD58A);
    if (frame.detail == Detail::kFull) frame.add_glow(place, 0.45 * high, with_alpha(glow, 0.16F));
    frame.add_glow(place, 0.20 * high, with_alpha(glow, 0.30F));
    frame.add_glow(place, 0.07 * high, color_of(0xFFE9BC, 0.75F));
    frame.add_circle(place, 0.016 * high, color_of(0xFFF8E6));
}

void add_ground_marks(SceneFrame& frame, const DrawnWorld& world, const Camera& camera,
                      const Viewport& viewport, double spacing) {
    if (!world.recipe.has_ground) return;
    const WorldWindow window = camera.window(viewport);
    const double length = 9.0 * camera.pixel();
    for (double i = std::ceil(window.low.x() / spacing); i * spacing < window.high.x(); i += 1.0)
        frame.add_box({i * spacing, frame.ground.at(i * spacing) - camera.pixel() - 0.5 * length},
                      {0.75 * camera.pixel(), 0.5 * length}, with_alpha(world.words, 0.55F));
}

void add_foreground(SceneFrame& frame, const DrawnWorld& world, const Camera& camera,
                    const Viewport& viewport, double time) {
    add_grass(frame, world, camera, viewport, time, kGrassBefore);
}

}  // namespace cambrian
