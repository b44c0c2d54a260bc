// The impacts that a scene lists, from which noise is made.
#include "planar/bodies.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

constexpr double kGravity = 10.0;  // m/s^2
constexpr double kFall = 1.0;      // m

Environment clay() {
    Environment environment;
    environment.gravity = kGravity;
    environment.elasticity = 0.0;
    return environment;
}

// Two bricks side by side, as two creatures, whose lowest corners are 1 m above ground.
BodyPlan two_bricks() {
    BodyPlan plan = one_box(0.15, 0.05, -1.0, kFall + 0.05);
    plan.parts.push_back(one_box(0.1, 0.1, 1.0, kFall + 0.1).parts[0]);
    return plan;
}

struct Heard {
    int tick = 0;
    SceneImpact impact;
};

std::vector<Heard> impacts_of(PhysicsScene& scene, int ticks) {
    std::vector<Heard> heard;
    std::vector<SceneImpact> impacts;
    for (int tick = 0; tick < ticks; ++tick) {
        REQUIRE(run(scene, kTestTick));
        scene.list_impacts(impacts);
        for (const SceneImpact& impact : impacts)
            heard.push_back({tick, impact});
    }
    return heard;
}

}  // namespace

TEST_CASE("a brick that falls from 1 m makes one impact, in the tick in which it lands",
          "[dynamics][impact]") {
    const auto scene = make_scene(two_bricks(), clay());
    const std::vector<Heard> heard = impacts_of(*scene, 60);
    const int landing = static_cast<int>(std::sqrt(2.0 * kFall / kGravity) / kTestTick);
    REQUIRE(heard.size() == 2);
    for (std::size_t brick = 0; brick < 2; ++brick) {
        const SceneImpact& impact = heard[brick].impact;
        CHECK(heard[brick].tick == landing);
        CHECK(impact.part == static_cast<int>(brick));
        CHECK(impact.other_part == -1);
        CHECK(impact.point.x() == Approx(brick == 0 ? -1.0 : 1.0).margin(1e-6));
        CHECK(impact.point.y() == Approx(0.0).margin(2e-3));
        const double mass = brick == 0 ? 0.3 * 0.1 : 0.2 * 0.2;
        CHECK(impact.impulse == Approx(mass * std::sqrt(2.0 * kGravity * kFall)).epsilon(0.01));
    }
}

TEST_CASE("impacts of parts of one creature are not listed", "[dynamics][impact]") {
    Environment space = empty_space();
    RandomStream random(stream_seed({31, 7}));
    std::uint64_t events = 0;
    for (int i = 0; i < 10; ++i) {
        const BodyPlan plan = random_tree(random, 6, 0.0, 60.0, 0.0);
        const auto scene = make_scene(plan, space);
        std::vector<SceneImpact> impacts;
        for (int tick = 0; tick < 120; ++tick) {
            flail(*scene, plan, 1.0);
            if (!run(*scene, kTestTick)) break;
            scene->list_impacts(impacts);
            REQUIRE(impacts.empty());
        }
        events += scene->audit().events;
    }
    CHECK(events > 0);
}
