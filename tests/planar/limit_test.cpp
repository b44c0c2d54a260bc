#include "planar/bodies.h"
#include "support/catch.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace cambrian;

TEST_CASE("a joint thrown against its stop stays there", "[dynamics][limit]") {
    BodyPlan plan = chain(2, 0.5);
    plan.parts[1].max_effort = 0.05;
    plan.parts[1].motor_mode = MotorMode::kTorque;
    const auto scene = make_scene(plan, empty_space());
    scene->set_target(1, 1.0);
    REQUIRE(run(*scene, 3.0));
    CHECK(scene->joint_coordinate(1) == Approx(0.5).margin(1e-4));
    CHECK(std::fabs(scene->joint_rate(1)) < 1e-6);
    CHECK(scene->audit().max_limit_overrun < 1e-2);
}

// A stop removes a joint's speed within two contact steps, each with a constant force. The error of
// its work is proportional to the step: 1.9 % at 1/60 s, 0.9 % at 1/120 s, 0.17 % at 1/480 s.
TEST_CASE("stops take energy and never give any", "[dynamics][limit]") {
    BodyPlan plan = chain(2, 0.5);
    plan.parts[1].max_effort = 0.05;
    plan.parts[1].motor_mode = MotorMode::kTorque;
    for (const double contact_step : {1.0 / 60, 1.0 / 120, 1.0 / 480}) {
        INFO(contact_step);
        SceneSettings settings;
        settings.contact_step = contact_step;
        const auto scene = make_scene(plan, empty_space(), settings);
        scene->set_target(1, 1.0);
        REQUIRE(run(*scene, 3.0));
        const SceneAudit& audit = scene->audit();
        CHECK(audit.limit_work == Approx(-audit.motor_work).epsilon(1.5 * contact_step));
        CHECK(audit.positive_work < 1e-2 * audit.gross_motor_work);
    }
}

TEST_CASE("a slide stops at its ends", "[dynamics][limit]") {
    BodyPlan plan = one_box(0.3, 0.1, 0.0, 0.0);
    PlannedPart& slide = attach(plan, 0, Vec3(0.3, 0.0, 0.0), 0.0, kLinearJoint);
    slide.limit_low = -0.1;
    slide.limit_high = 0.1;
    slide.max_effort = 1.0;
    slide.motor_mode = MotorMode::kTorque;
    const auto scene = make_scene(plan, empty_space());
    scene->set_target(1, -1.0);
    REQUIRE(run(*scene, 2.0));
    CHECK(scene->joint_coordinate(1) == Approx(-0.1).margin(1e-4));
    CHECK(scene->kinetic_energy() < 1e-12);
}

TEST_CASE("violent motors overrun limits by little", "[dynamics][limit]") {
    for (const Environment& environment : {Environment{}, empty_space()}) {
        std::vector<double> overruns;
        for (std::uint64_t seed = 0; seed < 44; ++seed) {
            RandomStream random(stream_seed({seed, 77}));
            const BodyPlan plan =
                random_tree(random, 3 + static_cast<int>(seed % 22), 0.2, 100.0, 0.0);
            const auto scene = make_scene(plan, environment);
            if (environment.has_ground) stand_on_ground(*scene);
            for (int tick = 0; tick < 180; ++tick) {
                flail(*scene, plan, 6.0);
                REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
            }
            overruns.push_back(scene->audit().max_limit_overrun);
        }
        std::sort(overruns.begin(), overruns.end());
        CHECK(overruns.back() <= 0.1);
        CHECK(overruns[overruns.size() / 2] <= 0.01);
    }
}
