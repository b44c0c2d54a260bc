#include "render/camera.h"

#include "support/catch.h"

namespace cambrian {
namespace {

constexpr Viewport kView{800.0, 600.0};

TEST_CASE("a point of the world is mapped to the screen and back", "[render][camera]") {
    Camera camera{.center = {3.0, 1.0}, .pixels_per_metre = 120.0};
    for (const Vec2& point : {Vec2(0.0, 0.0), Vec2(-7.5, 2.25), Vec2(3.0, 1.0)}) {
        const Vec2 back = camera.to_world(camera.to_screen(point, kView), kView);
        CHECK((back - point).norm() < 1e-12);
    }
}

TEST_CASE("the camera's centre is in the middle of the screen, and y points up",
          "[render][camera]") {
    const Camera camera{.center = {3.0, 1.0}};
    CHECK(camera.to_screen({3.0, 1.0}, kView) == Vec2(400.0, 300.0));
    CHECK(camera.to_screen({3.0, 2.0}, kView).y() < 300.0);
}

TEST_CASE("zooming keeps the point under the cursor", "[render][camera]") {
    Camera camera{.center = {3.0, 1.0}, .pixels_per_metre = 90.0};
    const Vec2 cursor(123.0, 456.0);
    const Vec2 before = camera.to_world(cursor, kView);
    camera.zoom_about(cursor, 1.7, kView);
    CHECK(camera.pixels_per_metre == Approx(153.0));
    CHECK((camera.to_world(cursor, kView) - before).norm() < 1e-12);
}

TEST_CASE("zooming stops at the camera's limits", "[render][camera]") {
    Camera camera;
    camera.zoom_about({400.0, 300.0}, 1e9, kView);
    CHECK(camera.pixels_per_metre == Camera::kMaxScale);
    camera.zoom_about({400.0, 300.0}, 1e-12, kView);
    CHECK(camera.pixels_per_metre == Camera::kMinScale);
}

TEST_CASE("panning moves the world with the mouse", "[render][camera]") {
    Camera camera;
    const Vec2 grabbed = camera.to_world({100.0, 100.0}, kView);
    camera.pan({40.0, -25.0});
    CHECK((camera.to_screen(grabbed, kView) - Vec2(140.0, 75.0)).norm() < 1e-9);
}

TEST_CASE("a fitted rectangle is completely inside the viewport", "[render][camera]") {
    Camera camera;
    const WorldWindow target{{-2.0, 0.0}, {6.0, 1.0}};
    camera.fit(target, 0.8, kView);
    CHECK((camera.center - Vec2(2.0, 0.5)).norm() < 1e-12);
    const WorldWindow seen = camera.window(kView);
    CHECK((seen.low.array() <= target.low.array()).all());
    CHECK((seen.high.array() >= target.high.array()).all());
    CHECK(camera.pixels_per_metre * 8.0 == Approx(0.8 * 800.0));
}

TEST_CASE("following closes in on its target without overshooting", "[render][camera]") {
    Camera camera;
    double distance = 5.0;
    for (int i = 0; i < 100; ++i) {
        camera.approach({3.0, 4.0}, 1.0 / 60.0, 0.2);
        const double left = (camera.center - Vec2(3.0, 4.0)).norm();
        REQUIRE(left < distance);
        distance = left;
    }
    CHECK(distance < 0.01);
}

TEST_CASE("what is kept in view moves the camera as little as is needed", "[render][camera]") {
    Camera camera;  // sees 8 m across and 6 m up
    const auto keep = [&](const Vec2& low, const Vec2& high) {
        camera.keep_in_view({low, high}, 0.05, kView);
    };
    keep({-1.0, -1.0}, {1.0, 1.0});
    CHECK(camera.center == Vec2(0.0, 0.0));
    keep({9.0, -1.0}, {10.0, 1.0});
    const double half = 0.45 * kView.width * camera.pixel();
    CHECK(camera.center.x() == Approx(10.0 - half));
    CHECK(camera.center.y() == 0.0);
    keep({-100.0, 0.0}, {100.0, 1.0});
    CHECK(camera.center.x() == Approx(0.0).margin(1e-12));
}

}  // namespace
}  // namespace cambrian
