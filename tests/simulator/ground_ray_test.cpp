// How far ground and walls are along a ray, and that numb creatures do not feel them.
#include "simulator/surroundings/ground_ray.h"

#include "core/random.h"
#include "simulator/surroundings/trial_surroundings.h"
#include "support/catch.h"

#include <cmath>
#include <limits>

using namespace cambrian;

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

TerrainSettings shape(const char* kind) {
    TerrainSettings settings;
    settings.kind = kind;
    return settings;
}

TrialSurroundings feeling(const Environment& environment) {
    return TrialSurroundings(environment, {}, {.feels_ground = true});
}

}  // namespace

TEST_CASE("level ground is below, and a box is where a ray enters it", "[simulator][whisker]") {
    CHECK(distance_to_level_ground({3.0, 0.5, 0.0}, -Vec3::UnitY()) == 0.5);
    CHECK(distance_to_level_ground({3.0, 0.5, 0.0}, Vec3(0.6, -0.8, 0.0)) == Approx(0.625));
    CHECK(distance_to_level_ground({3.0, 0.5, 0.0}, Vec3::UnitX()) == kNone);
    CHECK(distance_to_level_ground({3.0, -0.1, 0.0}, Vec3::UnitY()) == 0.0);
    const FixedBox box = box_around({2.0, 0.0, 0.0}, {2.0, 1.0, 0.0}, 0.1);
    CHECK(distance_to_box(box, {0.0, 0.5, 0.0}, Vec3::UnitX()) == Approx(1.9));
    CHECK(distance_to_box(box, {0.0, 0.5, 0.0}, -Vec3::UnitX()) == kNone);
    CHECK(distance_to_box(box, {0.0, 1.5, 0.0}, Vec3::UnitX()) == kNone);
    CHECK(distance_to_box(box, {2.0, 0.5, 0.0}, Vec3::UnitX()) == 0.0);
    CHECK(distance_to_box(box, {2.0, 3.1, 0.0}, -Vec3::UnitY()) == Approx(2.0));
}

TEST_CASE("a ray meets shaped ground where a walk along it does", "[simulator][whisker]") {
    constexpr double kReach = 1.0;
    constexpr double kStep = 5e-4;
    for (const char* kind : {"rough", "stairs", "gaps", "hurdles"}) {
        const auto terrain = Terrain::make(shape(kind));
        REQUIRE(terrain);
        RandomStream random(11);
        for (int i = 0; i < 100; ++i) {
            const double x = random.uniform(-8.0, 8.0);
            const Vec3 from(x, (*terrain)->height(x) + random.uniform(0.02, 0.6), 0.0);
            const double angle = random.uniform(-3.0, 3.0);
            const Vec3 way(std::cos(angle), std::sin(angle), 0.0);
            const double found = distance_to_terrain(**terrain, from, way, kReach);
            double walked = 0.0;
            const auto above = [&](double distance) {
                const Vec3 at = from + distance * way;
                return at.y() > (*terrain)->height(at.x());
            };
            while (walked < kReach && above(walked))
                walked += kStep;
            CAPTURE(kind, x, angle, walked);
            if (walked >= kReach) {
                CHECK(found >= kReach - 2.0 * kStep);
            } else if (found > walked + 2.0 * kStep || found < walked - 2.0 * kStep) {
                // A walk may step over a corner, but never through ground.
                CHECK(found < walked);
            }
        }
    }
}

TEST_CASE("the surroundings of a trial have ground and its height, but not for the numb",
          "[simulator][whisker]") {
    Environment environment;
    const Vec3 from(0.0, 0.3, 0.0);
    CHECK(feeling(environment).distance_to_ground(from, -Vec3::UnitY(), 1.0) == 0.3);
    CHECK(feeling(environment).ground_height(4.0) == 0.0);
    environment.terrain = shape("slope");
    environment.terrain.slope = 10.0;
    const TrialSurroundings slope = feeling(environment);
    const double rise = slope.ground_height(4.0);
    CHECK(rise == Approx(2.5 * std::tan(10.0 * 3.14159265358979 / 180.0)).epsilon(1e-6));
    CHECK(slope.distance_to_ground({4.0, rise + 0.2, 0.0}, -Vec3::UnitY(), 1.0) == Approx(0.2));
    const FixedBox box = box_around({0.5, 0.0, 0.0}, {0.5, 1.0, 0.0}, 0.1);
    TrialSurroundings walled = feeling(environment);
    walled.set_wall(&box);
    CHECK(walled.distance_to_ground(from, Vec3::UnitX(), 1.0) == Approx(0.4));
    environment.numb = true;
    TrialSurroundings numb = feeling(environment);
    numb.set_wall(&box);
    CHECK(numb.distance_to_ground(from, Vec3::UnitX(), 1.0) == kNone);
    CHECK(numb.ground_height(4.0) == 0.0);
    environment.numb = environment.has_ground = false;
    environment.terrain = {};
    CHECK(feeling(environment).distance_to_ground(from, -Vec3::UnitY(), 1.0) == kNone);
}
