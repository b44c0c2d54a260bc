// Bodies without muscles, which lose energy alone.

#include "planar/bodies.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

BodyPlan limp_creature(std::uint64_t seed) {
    RandomStream random(stream_seed({seed, 74}));
    const int parts = 3 + static_cast<int>(seed % 4) * 3;
    return random_tree(random, parts, seed % 5 == 4 ? 0.3 : 0.0, 0.0, 1.0);
}

// The greatest rise of the mechanical energy in one tick of the 3 s after a drop from half a metre,
// in weights times 1 m.
double greatest_rise(std::uint64_t seed) {
    const auto scene = make_scene(limp_creature(seed), Environment());
    scene->translate(Vec3(0.0, 0.5 - scene->lowest_point(), 0.0));
    double rise = 0.0;
    double before = scene->energy();
    for (int tick = 0; tick < 180; ++tick) {
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        rise = std::fmax(rise, scene->energy() - before);
        before = scene->energy();
    }
    return rise / (scene->mass() * kEarthGravity);
}

}  // namespace

TEST_CASE("the energy of a limp creature hardly ever rises", "[dynamics][limp]") {
    int rises = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        if (greatest_rise(seed) > 1e-3) ++rises;
    }
    CHECK(rises <= 1);
}
