#include "render/orbit_camera.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace cambrian {
namespace {

constexpr Viewport kOrbitView{640.0, 400.0};

// The point in the plane of the target, parallel to the picture, that is under a pixel.
Vec3 under(const OrbitCamera& camera, const Vec2& pixel) {
    const SpaceCamera seen = camera.seen(kOrbitView);
    return seen.place() + seen.direction(pixel.x(), pixel.y());
}

std::vector<Vec3> corners(const Vec3& half) {
    std::vector<Vec3> points;
    for (unsigned corner = 0; corner < 8; ++corner)
        points.push_back(
            half.cwiseProduct(Vec3((corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1,
                                   (corner & 4U) != 0 ? 1 : -1)));
    return points;
}

}  // namespace

TEST_CASE("what is under the cursor stays there while the camera comes closer", "[render][orbit]") {
    OrbitCamera camera;
    camera.target = {3.0, -1.0, 2.0};
    const Vec2 cursor(500.0, 90.0);
    const Vec3 before = under(camera, cursor);
    camera.zoom_about(cursor, 1.5, kOrbitView);
    CHECK(camera.distance == Approx(4.0 / 1.5));
    // The plane itself is nearer by as much; its point is under the same pixel.
    const Vec2 after = camera.seen(kOrbitView).look_at(before).place;
    CHECK(after.x() == Approx(cursor.x()).margin(1e-9));
    CHECK(after.y() == Approx(cursor.y()).margin(1e-9));
    for (int i = 0; i < 100; ++i)
        camera.zoom_about(cursor, 0.5, kOrbitView);
    CHECK(camera.distance == OrbitCamera::kFarthest);
}

TEST_CASE("a drag moves the world with the pointer", "[render][orbit]") {
    OrbitCamera camera;
    camera.yaw = 1.0;
    const Vec3 grabbed = under(camera, {200.0, 150.0});
    camera.pan({60.0, -25.0}, kOrbitView);
    const Vec2 after = camera.seen(kOrbitView).look_at(grabbed).place;
    CHECK(after.x() == Approx(260.0));
    CHECK(after.y() == Approx(125.0));
}

TEST_CASE("an orbit keeps target, distance and a level horizon", "[render][orbit]") {
    OrbitCamera camera;
    camera.target = {1.0, 2.0, 3.0};
    for (const Vec2& drag : {Vec2(130, 40), Vec2(-900, 2000), Vec2(77, -5000)}) {
        camera.orbit(drag);
        const SpaceCamera seen = camera.seen(kOrbitView);
        CHECK(seen.target == camera.target);
        CHECK(seen.distance() == Approx(4.0));
        CHECK(std::fabs(seen.right.y()) < 1e-12);
        CHECK(seen.up.y() > 0.0);
        CHECK(std::fabs(camera.pitch) <= OrbitCamera::kSteepest);
    }
}

TEST_CASE("all points fit into the share of the view that is asked for", "[render][orbit]") {
    for (const Vec3& half : {Vec3(1.0, 0.2, 0.2), Vec3(0.1, 2.0, 0.1), Vec3(0.3, 0.3, 3.0)}) {
        OrbitCamera camera;
        camera.target = {50.0, 0.0, 0.0};
        const std::vector<Vec3> points = corners(half);
        camera.fit(points, 0.5, kOrbitView);
        const SpaceCamera seen = camera.seen(kOrbitView);
        double most = 0.0;
        for (const Vec3& point : points) {
            const Vec2 at = seen.look_at(point).place;
            most = std::max(
                {most, std::fabs(at.x() - 320.0) / 320.0, std::fabs(at.y() - 200.0) / 200.0});
        }
        CHECK(most <= 0.5 + 1e-9);
        CHECK(most > 0.4);
        CHECK(camera.share_of(points, kOrbitView) > 0.4);
        CHECK(camera.share_of(points, kOrbitView) < 0.75);
    }
}

TEST_CASE("an axis is looked along from its end", "[render][orbit]") {
    OrbitCamera camera;
    for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
        camera.look_from(side);
        CHECK((camera.seen(kOrbitView).back - side).norm() < 1e-9);
    }
    camera.look_from({0, 1, 0});
    CHECK(camera.seen(kOrbitView).back.y() > 0.999);
    CHECK(camera.seen(kOrbitView).right.allFinite());
}

TEST_CASE("the camera follows with a lag, and never lets go", "[render][orbit]") {
    OrbitCamera camera;
    camera.approach({1.0, 0.0, 0.0}, 0.25, 0.25, 10.0);
    CHECK(camera.target.x() == Approx(1.0 - std::exp(-1.0)));
    camera.approach({100.0, 0.0, 0.0}, 0.01, 0.25, 2.0);
    CHECK(camera.target.x() == Approx(98.0));
}

}  // namespace cambrian
