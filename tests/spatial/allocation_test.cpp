#include "spatial/bodies.h"
#include "support/allocation_count.h"

#include <catch2/catch.hpp>

namespace cambrian {

TEST_CASE("Advancing in space allocates nothing", "[allocation]") {
    for (const bool on_ground : {false, true}) {
        for (const char* integrator : {"bogacki-shampine", "dormand-prince"}) {
            RandomStream random(stream_seed({115}));
            const BodyPlan plan = random_solid(random, 12, 25e3);
            SceneSettings settings;
            settings.integrator = integrator;
            Environment environment = on_ground ? spatial_ground(0.8, 0.2) : spatial_water();
            environment.self_contact = true;
            const auto scene = make_solid(plan, environment, settings);
            if (on_ground) scene->translate({0.0, 0.3 - scene->lowest_point(), 0.0});
            std::size_t allocations = 0;
            for (int tick = 0; tick < 300; ++tick) {
                swing(*scene, plan);
                const std::size_t before = test::allocation_count();
                REQUIRE(scene->advance(1.0 / 60) == SceneStatus::kRunning);
                allocations += test::allocation_count() - before;
            }
            CHECK(allocations == 0);
            CHECK(scene->audit().events > 0);
        }
    }
}

}  // namespace cambrian
