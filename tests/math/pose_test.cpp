#include "math/pose.h"

#include "core/random.h"
#include "math/bounds.h"
#include "support/catch.h"

using namespace cambrian;

TEST_CASE("a planar pose gives its angle back", "[math][pose]") {
    RandomStream stream(41);
    for (int i = 0; i < 10000; ++i) {
        const double angle = stream.uniform(-kPi, kPi);
        REQUIRE(planar_angle(planar_pose(1.0, 2.0, angle)) == Approx(angle).margin(1e-14));
    }
}

TEST_CASE("a planar pose turns about z and keeps the plane", "[math][pose]") {
    const Pose quarter = planar_pose(3.0, 4.0, kPi / 2);
    const Vec3 moved = transform(quarter, Vec3(1.0, 0.0, 0.0));
    CHECK(moved.x() == Approx(3.0));
    CHECK(moved.y() == Approx(5.0));
    CHECK(moved.z() == 0.0);
}

TEST_CASE("a pose keeps distances", "[math][pose]") {
    RandomStream stream(42);
    const auto point = [&] {
        return Vec3(stream.uniform(-1.0, 1.0), stream.uniform(-1.0, 1.0), 0.0);
    };
    for (int i = 0; i < 1000; ++i) {
        const Pose pose = planar_pose(stream.uniform(-9.0, 9.0), stream.uniform(-9.0, 9.0),
                                      stream.uniform(-kPi, kPi));
        const Vec3 a = point();
        const Vec3 b = point();
        REQUIRE((transform(pose, a) - transform(pose, b)).norm() == Approx((a - b).norm()));
    }
}

TEST_CASE("bounds grow to hold every point added", "[math][bounds]") {
    Bounds bounds;
    CHECK(bounds.low.x() > bounds.high.x());
    bounds.add(Vec3(1.0, -2.0, 0.0));
    bounds.add(Vec3(-1.0, 3.0, 0.0));
    CHECK(bounds.low == Vec3(-1.0, -2.0, 0.0));
    CHECK(bounds.high == Vec3(1.0, 3.0, 0.0));
}
