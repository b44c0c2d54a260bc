#include "preserve/world/broad_phase.h"

#include "core/random.h"
#include "preserve/world/rectangle.h"
#include "support/catch.h"

namespace cambrian {
namespace {

// Returns the pairs of all images up to some distance.
std::vector<BroadPhase::Pair> all_pairs(const std::vector<Bounds>& bounds,
                                        const Torus& torus = {}) {
    constexpr std::int32_t kMost = 10;
    const std::int32_t across = torus.width > 0.0 ? kMost : 0;
    const std::int32_t upwards = torus.height > 0.0 ? kMost : 0;
    std::vector<BroadPhase::Pair> pairs;
    for (std::uint32_t a = 0; a < bounds.size(); ++a) {
        for (std::uint32_t b = a + 1; b < bounds.size(); ++b) {
            for (std::int32_t x = -across; x <= across; ++x) {
                for (std::int32_t y = -upwards; y <= upwards; ++y) {
                    if (overlap(bounds[a], moved(bounds[b], torus.shift_of({x, y}))))
                        pairs.push_back({a, b, {x, y}});
                }
            }
        }
    }
    return pairs;
}

TEST_CASE("the grid finds exactly the overlapping pairs", "[preserve]") {
    RandomStream random(stream_seed({1, static_cast<std::uint64_t>(Purpose::kTest)}));
    BroadPhase meetings;
    std::size_t found = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<Bounds> bounds;
        // Some worlds reach beyond the last cells.
        const double size = round % 10 == 0 ? 4000.0 : 20.0;
        for (int i = 0; i < 120; ++i) {
            const Vec3 low(random.uniform(-size, size), random.uniform(-size, size), 0.0);
            const Vec3 sides(random.uniform(0.1, 5.0), random.uniform(0.1, 5.0), 0.0);
            bounds.push_back({low, low + sides});
        }
        const auto pairs = meetings.find(bounds);
        CHECK(std::vector<BroadPhase::Pair>(pairs.begin(), pairs.end()) == all_pairs(bounds));
        found += pairs.size();
    }
    CHECK(found > 10'000);
}

TEST_CASE("where edges meet, the grid finds exactly the images that overlap", "[preserve][edges]") {
    RandomStream random(stream_seed({3, static_cast<std::uint64_t>(Purpose::kTest)}));
    // Bodies may be longer than the smallest world.
    for (const Torus torus : {Torus{5.0, 5.0}, Torus{12.0, 0.0}, Torus{13.7, 8.1}}) {
        BroadPhase meetings(torus);
        std::size_t found = 0;
        for (int round = 0; round < 20; ++round) {
            std::vector<Bounds> bounds;
            for (int i = 0; i < 40; ++i) {
                const Vec3 low(random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0), 0.0);
                const Vec3 sides(random.uniform(0.1, 6.0), random.uniform(0.1, 3.0), 0.0);
                bounds.push_back({low, low + sides});
            }
            const auto pairs = meetings.find(bounds);
            CHECK(std::vector<BroadPhase::Pair>(pairs.begin(), pairs.end()) ==
                  all_pairs(bounds, torus));
            found += pairs.size();
        }
        CHECK(found > 300);
    }
}

TEST_CASE("rectangles overlap exactly where they share a point", "[preserve]") {
    const Rectangle flat{Vec3::Zero(), Vec3::UnitX(), 1.0, 0.5};
    Rectangle tilted{Vec3(0.0, 0.0, 0.0), Vec3(1.0, 1.0, 0.0).normalized(), 1.0, 1.0};
    const double reach = std::sqrt(2.0);  // of the tilted square along x
    tilted.center = Vec3(1.0 + reach - 1e-9, 0.0, 0.0);
    CHECK(overlap(flat, tilted));
    tilted.center = Vec3(1.0 + reach + 1e-9, 0.0, 0.0);
    CHECK_FALSE(overlap(flat, tilted));
    // The bounds of both overlap here, but not the rectangles.
    tilted.center = Vec3(1.0 + 0.8 * reach, 0.5 + 0.8 * reach, 0.0);
    CHECK(overlap(bounds_of(flat), bounds_of(tilted)));
    CHECK_FALSE(overlap(flat, tilted));
}

TEST_CASE("the distance to a rectangle is that to its nearest point", "[preserve]") {
    const Rectangle part{Vec3(1.0, 2.0, 0.0), Vec3::UnitY(), 1.0, 0.5};
    CHECK(distance_to(part, Vec3(1.2, 2.5, 0.0)) == 0.0);
    CHECK(distance_to(part, Vec3(1.0, 3.25, 0.0)) == Approx(0.25));
    CHECK(distance_to(part, Vec3(1.5 + 0.3, 3.0 + 0.4, 0.0)) == Approx(0.5));
}

}  // namespace
}  // namespace cambrian
