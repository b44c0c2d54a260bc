#include "render/pixel_rect.h"

#include "support/catch.h"

namespace cambrian {
namespace {

// A target with 100 pixels per metre and the origin in the middle.
const PixelRect kTarget{.x = 30, .y = 40, .width = 200, .height = 100};

Shape box(const Vec2& center, const Vec2& half_extents) {
    return {.center = center, .half_extents = half_extents};
}

std::optional<PixelRect> pixels_of(const Shape& shape, const Camera& camera = {}) {
    return pixels_of_box(shape, camera, kTarget);
}

TEST_CASE("a box covers the pixels nearest to it", "[render][pixel_rect]") {
    CHECK(pixels_of(box({0.0, 0.0}, {0.1, 0.05})) == PixelRect{120, 85, 20, 10});
    CHECK(pixels_of(box({0.5, -0.2}, {0.1, 0.05})) == PixelRect{170, 65, 20, 10});
    CHECK(pixels_of(box({0.004, 0.0}, {0.1, 0.05})) == PixelRect{120, 85, 20, 10});
}

TEST_CASE("a line has the same width everywhere, at least one pixel", "[render][pixel_rect]") {
    for (int i = 0; i < 1000; ++i) {
        INFO(i);
        const auto line = pixels_of(box({1e-4 * i, 0.0}, {0.001, 0.2}));
        REQUIRE(line);
        CHECK(line->width == 1);
        CHECK(line->height == 40);
    }
}

TEST_CASE("a box is clipped at the edges of the target", "[render][pixel_rect]") {
    CHECK(pixels_of(box({0.0, -50.0}, {100.0, 50.0})) == PixelRect{30, 40, 200, 50});
    CHECK(pixels_of(box({1e12, 0.0}, {1.0, 1.0}))->width == 0);
    CHECK(pixels_of(box({0.0, 7.0}, {1.0, 1.0}))->height == 0);
}

TEST_CASE("a box moves with the camera", "[render][pixel_rect]") {
    const Camera camera{.center = {1.0, 2.0}, .pixels_per_metre = 10.0};
    CHECK(pixels_of(box({2.0, 1.0}, {1.0, 0.5}), camera) == PixelRect{130, 75, 20, 10});
}

TEST_CASE("only opaque, upright boxes without outline are pixels", "[render][pixel_rect]") {
    const Shape plain = box({0.0, 0.0}, {0.1, 0.1});
    CHECK(pixels_of(plain));
    Shape other = plain;
    other.angle = 0.1;
    CHECK_FALSE(pixels_of(other));
    other = plain;
    other.radius = 0.01;
    CHECK_FALSE(pixels_of(other));
    other = plain;
    other.outline_width = 0.01;
    CHECK_FALSE(pixels_of(other));
    other = plain;
    other.blur = 0.01;
    CHECK_FALSE(pixels_of(other));
    other = plain;
    other.fill.a = 0.5F;
    CHECK_FALSE(pixels_of(other));
}

}  // namespace
}  // namespace cambrian
