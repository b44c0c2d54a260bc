#include "planar/bodies.h"
#include "support/allocation_count.h"
#include "support/catch.h"

using namespace cambrian;
using test::allocation_count;

TEST_CASE("advancing allocates nothing", "[dynamics][allocation]") {
    for (const char* integrator : {"bogacki-shampine", "dormand-prince", "cash-karp"}) {
        RandomStream random(stream_seed({61}));
        const BodyPlan plan = random_tree(random, 12, 0.2, 30.0, 1.2);
        SceneSettings settings;
        settings.integrator = integrator;
        const auto scene = make_scene(plan, {}, settings);
        std::size_t allocations = 0;
        for (int tick = 0; tick < 300; ++tick) {
            flail(*scene, plan, 3.0);
            const std::size_t before = allocation_count();
            static_cast<void>(scene->advance(kTestTick));
            allocations += allocation_count() - before;
        }
        CHECK(scene->audit().events > 0);
        CHECK(allocations == 0);
    }
}

TEST_CASE("the allocation counter counts", "[dynamics][allocation]") {
    const std::size_t before = allocation_count();
    const auto* number = new volatile int(3);
    const std::size_t after = allocation_count();
    delete number;
    CHECK(after == before + 1);
}
