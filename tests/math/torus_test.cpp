#include "math/torus.h"

#include "core/random.h"
#include "support/catch.h"

#include <vector>

namespace cambrian {
namespace {

constexpr Torus kTorus{7.0, 5.3};

Bounds random_box(RandomStream& random, double far, double longest) {
    const Vec3 low(random.uniform(-far, far), random.uniform(-far, far), 0.0);
    return {low, low + Vec3(random.uniform(0.0, longest), random.uniform(0.0, longest), 0.0)};
}

TEST_CASE("the shortest way on a torus is at most half a width and half a height", "[math]") {
    CHECK(kTorus.shortest({3.0, 2.0, 0.0}) == Vec3(3.0, 2.0, 0.0));
    CHECK(kTorus.shortest({4.0, -3.0, 0.0}).isApprox(Vec3(-3.0, 2.3, 0.0)));
    CHECK(kTorus.shortest({-700.0, 0.0, 0.0}) == Vec3::Zero());
    RandomStream random(stream_seed({1, static_cast<std::uint64_t>(Purpose::kTest)}));
    for (int i = 0; i < 1000; ++i) {
        const Vec3 way(random.uniform(-90.0, 90.0), random.uniform(-90.0, 90.0), 0.0);
        const Vec3 shortest = kTorus.shortest(way);
        CHECK(std::fabs(shortest.x()) <= 3.5 + 1e-12);
        CHECK(std::fabs(shortest.y()) <= 2.65 + 1e-12);
        CHECK((shortest + kTorus.shift_of(kTorus.image_of(way)) - way).norm() < 1e-12);
    }
}

TEST_CASE("where edges do not meet, nothing has images", "[math]") {
    const Vec3 way(1e9, -0.0, 0.0);
    CHECK(Torus{}.shortest(way) == way);
    CHECK(Torus{2.0, 0.0}.shortest({1.5, 9.0, 0.0}) == Vec3(-0.5, 9.0, 0.0));
    int count = 0;
    Torus{}.visit_images({Vec3::Zero(), Vec3::Ones()}, {Vec3::Ones(), 2.0 * Vec3::Ones()},
                         [&](const Vec3& shift) {
                             ++count;
                             CHECK(shift == Vec3::Zero());
                         });
    CHECK(count == 1);
}

TEST_CASE("exactly the images of a box are visited that meet the other one", "[math]") {
    RandomStream random(stream_seed({2, static_cast<std::uint64_t>(Purpose::kTest)}));
    for (int round = 0; round < 500; ++round) {
        const Bounds of = random_box(random, 20.0, 9.0);
        const Bounds at = random_box(random, 20.0, 9.0);
        int expected = 0;
        for (std::int32_t x = -9; x <= 9; ++x) {
            for (std::int32_t y = -12; y <= 12; ++y)
                expected += overlap(moved(of, kTorus.shift_of({x, y})), at) ? 1 : 0;
        }
        int count = 0;
        kTorus.visit_images(of, at, [&](const Vec3& shift) {
            ++count;
            CHECK(overlap(moved(of, shift), at));
        });
        CHECK(count == expected);
    }
}

}  // namespace
}  // namespace cambrian
