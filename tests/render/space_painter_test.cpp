#include "render/box_mesh.h"
#include "render/opengl/framebuffer.h"
#include "render/opengl/offscreen_context.h"
#include "render/opengl/pixels.h"
#include "render/orbit_camera.h"
#include "render/renderer.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

namespace cambrian {
namespace {

constexpr int kWide = 240;
constexpr int kHigh = 160;

class SpaceEasel {
public:
    SpaceEasel() {
        auto context = OffscreenContext::create();
        REQUIRE(context);
        context_ = std::move(*context);
        auto renderer = Renderer::create();
        REQUIRE(renderer);
        renderer_ = std::move(*renderer);
    }
    Image picture(SpaceFrame space) {
        auto framebuffer = Framebuffer::create(kWide, kHigh);
        REQUIRE(framebuffer);
        framebuffer->bind();
        SceneFrame frame;
        frame.space = std::make_shared<const SpaceFrame>(std::move(space));
        renderer_->draw(frame, Camera{}, {0, 0, kWide, kHigh});
        return read_pixels(kWide, kHigh);
    }

private:
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<Renderer> renderer_;
};

Solid box_at(const Vec3& place, const Vec3& half, const Color& fill) {
    Solid solid;
    solid.pose.position = place;
    solid.half_extents = half;
    solid.radius = 0.02;
    solid.fill = fill;
    return solid;
}

SpaceFrame box_over_floor() {
    OrbitCamera orbit;
    orbit.target = {0.0, 0.6, 0.0};
    orbit.distance = 6.0;
    SpaceFrame frame;
    frame.camera = orbit.seen({kWide, kHigh});
    frame.light.above = color_of(0xD0D8E0);
    frame.light.below = color_of(0x606060);
    frame.light.around = {color_of(0xA0B0C0), color_of(0x4060A0), color_of(0x203040)};
    frame.light.direction = {0.0, 1.0, 0.0};
    frame.light.haze_from = 100.0;
    frame.floor = SpaceFloor{};
    frame.floor->color = color_of(0x808080);
    frame.solids.push_back(box_at({0.0, 1.0, 0.0}, {0.5, 0.2, 0.3}, color_of(0xE04030)));
    return frame;
}

Vec2 seen(const SpaceFrame& frame, const Vec3& point) {
    return frame.camera.look_at(point).place;
}

double bright(const Image& image, const Vec2& at) {
    const std::uint8_t* pixel = image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
    return pixel[0] + pixel[1] + pixel[2];
}

bool is_red(const Image& image, const Vec2& at) {
    const std::uint8_t* pixel = image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
    return pixel[0] > 2 * pixel[2];
}

}  // namespace

TEST_CASE("the mesh of a box is closed and turned outwards", "[render][space]") {
    for (const int steps : {1, 3}) {
        const BoxMesh mesh = rounded_box(steps);
        const Vec3 half(0.7, 0.4, 0.2);
        const double radius = 0.1;
        const auto place = [&](unsigned index) {
            const BoxVertex& vertex = mesh.vertices[index];
            Vec3 at;
            for (int k = 0; k < 3; ++k) {
                const auto axis = static_cast<std::size_t>(k);
                at[k] = static_cast<double>(vertex.corner[axis]) * (half[k] - radius) +
                        static_cast<double>(vertex.normal[axis]) * radius;
            }
            return at;
        };
        double volume = 0.0;  // of the tetrahedra between the triangles and the middle
        for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
            const Vec3 a = place(mesh.triangles[i]);
            const Vec3 b = place(mesh.triangles[i + 1]);
            const Vec3 c = place(mesh.triangles[i + 2]);
            CHECK(a.dot(b.cross(c)) > -1e-9);
            volume += a.dot(b.cross(c)) / 6.0;
        }
        const double whole = 8.0 * half.prod();
        CHECK(volume < whole);
        CHECK(volume > 0.85 * whole);
        for (unsigned i = 0; i < mesh.vertices.size(); ++i)
            CHECK((place(i).cwiseAbs() - half).maxCoeff() < 1e-6);
    }
}

TEST_CASE("a solid is drawn where the camera sees it", "[render][space]") {
    SpaceEasel easel;
    for (const int samples : {1, 2}) {
        SpaceFrame frame = box_over_floor();
        frame.samples = samples;
        const Image image = easel.picture(frame);
        const Vec3 middle = frame.solids[0].pose.position;
        CHECK(is_red(image, seen(frame, middle)));
        for (const Vec3& inside : {Vec3(0.4, 0.0, 0.3), Vec3(-0.4, 0.1, 0.3), Vec3(0.5, 0.1, 0.2)})
            CHECK(is_red(image, seen(frame, middle + inside)));
        for (const Vec3& outside : {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.8, 0.0), Vec3(-1.0, 0.0, 0.0)})
            CHECK_FALSE(is_red(image, seen(frame, middle + outside)));
    }
}

TEST_CASE("a solid hides what is behind it and shades the floor below it", "[render][space]") {
    SpaceEasel easel;
    SpaceFrame frame = box_over_floor();
    const Image before = easel.picture(frame);
    const Vec2 below = seen(frame, {0.0, 0.0, 0.0});
    const Vec2 aside = seen(frame, {1.4, 0.0, 0.0});
    CHECK(bright(before, below) < 0.8 * bright(before, aside));

    SpaceFrame hidden = frame;
    const Vec3 way = frame.camera.back;
    hidden.solids.push_back(
        box_at(Vec3(0.0, 1.0, 0.0) - 1.5 * way, Vec3::Constant(0.15), color_of(0x2040E0)));
    const Image after = easel.picture(hidden);
    CHECK(is_red(after, seen(frame, {0.0, 1.0, 0.0})));

    hidden.solids.back() =
        box_at(Vec3(0.0, 1.0, 0.0) + 1.5 * way, Vec3::Constant(0.15), color_of(0x2040E0));
    CHECK_FALSE(is_red(easel.picture(hidden), seen(frame, {0.0, 1.0, 0.0})));
}

TEST_CASE("marks behind a solid are hidden by it", "[render][space]") {
    SpaceEasel easel;
    for (const double side : {1.0, -1.0}) {
        SpaceFrame frame = box_over_floor();
        frame.marks.push_back({.place = Vec3(0.0, 1.0, 0.0) + side * frame.camera.back,
                               .radius = 0.1,
                               .color = color_of(0x20E040)});
        const Image image = easel.picture(frame);
        CHECK(is_red(image, seen(frame, {0.0, 1.0, 0.0})) == (side < 0.0));
    }
}

TEST_CASE("a moment in space has the same bytes each time", "[render][space]") {
    SpaceEasel easel;
    SpaceFrame frame = box_over_floor();
    frame.floor->grain = 0.4F;
    frame.floor->ripples = 0.4F;
    frame.floor->lines = color_of(0x000000, 0.5F);
    const Image first = easel.picture(frame);
    static_cast<void>(easel.picture(box_over_floor()));
    CHECK(easel.picture(frame).rgb == first.rgb);
    SpaceEasel other;
    CHECK(other.picture(frame).rgb == first.rgb);
}

TEST_CASE("the same body far from the origin has the same picture", "[render][space]") {
    SpaceEasel easel;
    SpaceFrame frame = box_over_floor();
    const Image here = easel.picture(frame);
    const Vec3 away(1000.0, 0.0, -2000.0);
    frame.camera.target += away;
    for (Solid& solid : frame.solids)
        solid.pose.position += away;
    const Image there = easel.picture(frame);
    int different = 0;
    for (std::size_t i = 0; i < here.rgb.size(); ++i)
        different += std::abs(here.rgb[i] - there.rgb[i]) > 2 ? 1 : 0;
    CHECK(different < 20);
}

}  // namespace cambrian
