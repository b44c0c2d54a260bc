#include "pictures/scene/scenery.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cambrian {
namespace {

constexpr double kLeastBladePixels = 3.0;

// Returns a number in [0, 1) that follows from a place and a use.
double scattered(std::int64_t place, std::uint32_t use) {
    auto bits = static_cast<std::uint32_t>(place) * 0x9E3779B1U ^ use * 0x85EBCA77U;
    bits = (bits ^ (bits >> 15U)) * 0x2C1B3C6DU;
    bits = (bits ^ (bits >> 12U)) * 0x297A2D39U;
    return static_cast<double>((bits ^ (bits >> 15U)) >> 8U) / 16777216.0;
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
