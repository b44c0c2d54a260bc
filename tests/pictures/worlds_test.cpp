// What environments look like, drawn without a display.

#include "pictures/scene/worlds.h"

#include "pictures/scene/scenery.h"
#include "pictures/scene/shaped_ground.h"
#include "render/opengl/framebuffer.h"
#include "render/opengl/offscreen_context.h"
#include "render/opengl/pixels.h"
#include "render/renderer.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

constexpr std::array kAllWorlds = {WorldKind::kMeadow, WorldKind::kIce,      WorldKind::kMoon,
                                   WorldKind::kWater,  WorldKind::kSeabed,   WorldKind::kAir,
                                   WorldKind::kNight,  WorldKind::kNightSea, WorldKind::kNightSky};

template <class Thing>
Thing opened(Result<Thing> thing) {
    INFO((thing ? std::string() : thing.error().message));
    REQUIRE(thing);
    return std::move(*thing);
}

class Easel {
public:
    Image picture(const SceneFrame& frame, const Camera& camera, int width, int height,
                  Baking baking = Baking::kAtOnce) {
        const Framebuffer framebuffer = opened(Framebuffer::create(width, height));
        framebuffer.bind();
        renderer_->draw(frame, camera, {0, 0, width, height}, baking);
        return read_pixels(width, height);
    }
    bool take_unfinished() { return renderer_->take_unfinished(); }
    Image picture(WorldKind kind, const Vec2& center, double scale = 100.0) {
        Camera camera;
        camera.center = center;
        camera.pixels_per_metre = scale;
        SceneFrame frame;
        add_scenery(frame, drawn_world(kind, Daytime::kNoon), camera, {320.0, 200.0}, 1.5);
        add_foreground(frame, drawn_world(kind, Daytime::kNoon), camera, {320.0, 200.0}, 1.5);
        return picture(frame, camera, 320, 200);
    }

private:
    std::unique_ptr<OffscreenContext> context_ = opened(OffscreenContext::create());
    std::unique_ptr<Renderer> renderer_ = opened(Renderer::create());
};

// Rows count from the top.
Color pixel(const Image& image, int x, int y) {
    const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x));
    const auto part = [&](std::size_t i) { return static_cast<float>(image.rgb[at + i]) / 255.0F; };
    return {part(0), part(1), part(2), 1.0F};
}

double difference(const Color& a, const Color& b) {
    return static_cast<double>(std::fabs(a.r - b.r) + std::fabs(a.g - b.g) + std::fabs(a.b - b.b));
}

TEST_CASE("an environment decides which world is drawn", "[pictures][worlds]") {
    Environment environment;
    CHECK(world_kind_of(environment) == WorldKind::kMeadow);
    environment.friction = 0.05;
    CHECK(world_kind_of(environment) == WorldKind::kIce);
    environment.gravity = 1.62;
    CHECK(world_kind_of(environment) == WorldKind::kMoon);
    environment.viscosity_quadratic = 1.0;
    CHECK(world_kind_of(environment) == WorldKind::kSeabed);
    environment.has_ground = false;
    CHECK(world_kind_of(environment) == WorldKind::kWater);
    environment.has_light = true;
    CHECK(world_kind_of(environment) == WorldKind::kNightSea);
    environment.viscosity_quadratic = 0.0;
    CHECK(world_kind_of(environment) == WorldKind::kNightSky);
    environment.has_ground = true;
    CHECK(world_kind_of(environment) == WorldKind::kNight);
    environment.has_ground = false;
    environment.has_light = false;
    CHECK(world_kind_of(environment) == WorldKind::kAir);
}

TEST_CASE("a moment of a world has the same bytes whatever was drawn before",
          "[pictures][worlds][picture]") {
    Easel first;
    for (const WorldKind kind : kAllWorlds) {
        const Image before = first.picture(kind, {0.3, 0.5});
        // Moves and zooms between, which scales the ground anew.
        first.picture(kind, {7.9, 0.2}, 180.0);
        CHECK(first.picture(kind, {0.3, 0.5}).rgb == before.rgb);
    }
    Easel second;
    CHECK(second.picture(WorldKind::kWater, {0.3, 0.5}).rgb ==
          first.picture(WorldKind::kWater, {0.3, 0.5}).rgb);
}

TEST_CASE("scenery that is painted in steps has the bytes of one that is painted at once",
          "[pictures][worlds][picture]") {
    Camera camera;
    camera.center = {0.3, 0.5};
    for (const WorldKind kind : {WorldKind::kMeadow, WorldKind::kWater}) {
        SceneFrame frame;
        use_world(frame, drawn_world(kind, Daytime::kDusk));
        const Image at_once = Easel().picture(frame, camera, 320, 200);
        Easel patient;
        Image image = patient.picture(frame, camera, 320, 200, Baking::kInSteps);
        CHECK(patient.take_unfinished());
        CHECK_FALSE(patient.take_unfinished());
        CHECK(image.rgb != at_once.rgb);
        CHECK(difference(pixel(image, 160, 1), frame.backdrop->sky[2]) < 0.1);
        do {
            image = patient.picture(frame, camera, 320, 200, Baking::kInSteps);
        } while (patient.take_unfinished());
        CHECK(image.rgb == at_once.rgb);
        // A picture does not wait for steps.
        Easel hasty;
        hasty.picture(frame, camera, 320, 200, Baking::kInSteps);
        CHECK(hasty.picture(frame, camera, 320, 200).rgb == at_once.rgb);
    }
}

// Whether a row of a picture is that of another one, moved by some pixels to the left.
bool moved_by(const Image& after, const Image& before, int y, int pixels) {
    for (int x = 0; x < after.width - pixels; ++x)
        if (difference(pixel(after, x, y), pixel(before, x + pixels, y)) > 0.0) return false;
    return true;
}

TEST_CASE("ground begins at height 0 and moves with the camera, what is far moves slower",
          "[pictures][worlds][picture]") {
    Easel easel;
    for (const WorldKind kind : kAllWorlds) {
        INFO(static_cast<int>(kind));
        SceneFrame frame;
        frame.backdrop = &drawn_world(kind, Daytime::kNoon).recipe;
        Camera camera;
        camera.pixels_per_metre = 100.0;
        camera.center = {0.0, 0.5};
        const Image before = easel.picture(frame, camera, 320, 200);
        camera.center.x() += 0.4;  // 40 pixels
        const Image after = easel.picture(frame, camera, 320, 200);
        // The middle of 200 rows is at 0.5 m, so y = 0 lies 50 pixels below it.
        const bool ground = frame.backdrop->has_ground;
        for (const int y : {151, 199})
            CHECK(moved_by(after, before, y, ground ? 40 : 4));
        for (const int y : {0, 148})
            CHECK(moved_by(after, before, y, 4));
    }
}

TEST_CASE("ground with a shape fills what is below its surface, and grass follows it",
          "[pictures][worlds][picture]") {
    Easel easel;
    Environment environment;
    environment.terrain.kind = "drawn";
    environment.terrain.points = "-1 0; 0 0; 0.5 0.5; 0.5 1; 9 1";
    Camera camera;
    camera.pixels_per_metre = 100.0;
    camera.center = {0.0, 0.5};
    const DrawnWorld& world = drawn_world(WorldKind::kMeadow, Daytime::kNoon);
    SceneFrame frame;
    use_ground(frame, environment, camera, {320.0, 200.0});
    CHECK(frame.ground.at(-0.5) == 0.0);
    CHECK(frame.ground.at(0.25) == Approx(0.25));
    CHECK(frame.ground.at(0.75) == Approx(1.0));
    add_scenery(frame, world, camera, {320.0, 200.0}, 0.0);
    const auto foot = [](const Shape& blade) {
        return Vec2(blade.center +
                    blade.half_extents.y() * Vec2(std::sin(blade.angle), -std::cos(blade.angle)));
    };
    int blades = 0;
    for (const Shape& shape : frame.shapes) {
        if (shape.half_extents.x() > 0.01 || shape.half_extents.y() < 0.01) continue;
        CHECK(foot(shape).y() == Approx(frame.ground.at(foot(shape).x()) - 0.008).margin(1e-6));
        ++blades;
    }
    CHECK(blades > 40);
    frame.shapes.clear();
    const Image image = easel.picture(frame, camera, 320, 200);
    // Of the soil below the surface no colour is that of the sky above it.
    const auto blue = [&](double x, double y) {
        const auto column = static_cast<std::size_t>(160.0 + 100.0 * x);
        const auto row = static_cast<std::size_t>(100.0 - 100.0 * (y - 0.5));
        return static_cast<int>(image.rgb[3 * (320 * row + column) + 2]);
    };
    CHECK(blue(0.25, 0.15) < 100);  // in the slope
    CHECK(blue(0.7, 0.9) < 100);    // in the block behind it
    CHECK(blue(0.25, 0.95) > 120);  // above the slope
    CHECK(blue(-0.7, 0.9) > 120);
}

TEST_CASE("views of any size and place have a backdrop", "[pictures][worlds][picture]") {
    Easel easel;
    SceneFrame frame;
    frame.backdrop = &drawn_world(WorldKind::kMeadow, Daytime::kDusk).recipe;
    for (const Vec2& center : {Vec2(0.0, 0.0), Vec2(-1e6, 1e5), Vec2(1e6, -1e5)}) {
        for (const double scale : {Camera::kMinScale, 100.0, Camera::kMaxScale}) {
            Camera camera;
            camera.center = center;
            camera.pixels_per_metre = scale;
            const Image image = easel.picture(frame, camera, 67, 41);
            CHECK(difference(pixel(image, 33, 20), color_of(0x000000)) > 0.05);
        }
    }
}

}  // namespace
}  // namespace cambrian
