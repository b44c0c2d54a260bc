#include "planar/bodies.h"
#include "support/catch.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace cambrian;

namespace {

struct World {
    Environment environment;
    double strength;   // N
    double frequency;  // Hz
    double linear;     // share of linear joints
};

World world_of(std::uint64_t seed) {
    constexpr double kFrictions[] = {0.0, 0.4, 0.8, 1.2};
    constexpr double kElasticities[] = {0.0, 0.3, 0.6};
    World world{{}, seed % 2 == 0 ? 20.0 : 100.0, seed % 2 == 0 ? 2.0 : 6.0, 0.2};
    world.environment.friction = kFrictions[seed % 4];
    world.environment.elasticity = kElasticities[seed % 3];
    if (seed % 5 == 4) world.environment = open_water();
    return world;
}

SceneAudit audit_of(std::uint64_t seed, double duration) {
    RandomStream random(stream_seed({seed, 71}));
    const World world = world_of(seed);
    const BodyPlan plan =
        random_tree(random, random.between(3, 24), world.linear, world.strength, 0.0);
    const auto scene = make_scene(plan, world.environment);
    stand_on_ground(*scene);
    while (scene->time() < duration) {
        flail(*scene, plan, world.frequency);
        INFO("seed " << seed << " at " << scene->time());
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
    }
    return scene->audit();
}

}  // namespace

TEST_CASE("random creatures never break physics", "[dynamics][robustness]") {
    int suspect = 0;
    const int creatures = 60;
    for (std::uint64_t seed = 0; seed < creatures; ++seed) {
        const SceneAudit audit = audit_of(seed, 3.0);
        INFO("seed " << seed);
        CHECK(audit.evaluations < 5000 * 3);
        CHECK(audit.max_penetration < 0.05);
        CHECK(audit.max_limit_overrun <= 0.1);
        const bool honest = std::fabs(audit.energy_residual) < 0.05 * audit.energy_scale &&
                            audit.positive_work < 0.1 * audit.energy_scale;
        suspect += honest ? 0 : 1;
    }
    CHECK(suspect <= creatures / 20);
}

TEST_CASE("creatures that hold a pose come to rest", "[dynamics][robustness]") {
    const int creatures = 30;
    for (const int parts : {3, 6, 12}) {
        int at_rest = 0;
        for (std::uint64_t seed = 0; seed < creatures; ++seed) {
            RandomStream random(stream_seed({seed, 72}));
            const BodyPlan plan = random_tree(random, parts, 0.0, 20.0, 0.0);
            const auto scene = make_scene(plan, {});
            stand_on_ground(*scene);
            REQUIRE(run(*scene, 15.0));
            const std::uint64_t events = scene->audit().events;
            double fastest = 0.0;
            for (int tick = 0; tick < 5 * 60; ++tick) {
                REQUIRE(run(*scene, kTestTick));
                for (std::size_t i = 0; i < plan.parts.size(); ++i)
                    fastest = std::fmax(fastest, scene->part_twist(i).linear.norm());
            }
            at_rest += fastest <= 1e-3 && scene->audit().events == events ? 1 : 0;
        }
        INFO(parts << " parts");
        CHECK(at_rest >= 0.95 * creatures);
    }
}
