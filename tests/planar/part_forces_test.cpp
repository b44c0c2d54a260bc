#include "math/angle.h"
#include "planar/bodies.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

BodyPlan measured(BodyPlan plan) {
    for (PlannedPart& part : plan.parts)
        part.measures_forces = true;
    return plan;
}

double total_load(const PhysicsScene& scene) {
    double sum = 0.0;
    for (std::size_t part = 0; part < scene.part_count(); ++part)
        sum += scene.part_load(part);
    return sum;
}

}  // namespace

TEST_CASE("a block at rest on a slope feels the sine and cosine of its tilt",
          "[dynamics][forces]") {
    for (const double tilt : {-20.0, 0.0, 10.0, 30.0}) {
        INFO(tilt << " degrees");
        Environment slope;
        slope.gravity_direction = -90.0 + tilt;
        const auto scene = make_scene(measured(one_box(0.3, 0.1, 0.0, 0.101)), slope);
        REQUIRE(run(*scene, 2.0));
        const Vec3 felt = scene->part_specific_force(0) / 9.81;
        CHECK(felt.x() == Approx(-sine(to_radians(tilt))).margin(1e-3));
        CHECK(felt.y() == Approx(cosine(to_radians(tilt))).margin(1e-3));
        const double weight = scene->mass() * 9.81 * cosine(to_radians(tilt));
        CHECK(total_load(*scene) / weight == Approx(1.0).margin(1e-3));
    }
}

TEST_CASE("the loads of a standing creature's parts sum to its weight", "[dynamics][forces]") {
    const BodyPlan plan = measured(chain(4, 1.0, 0.0, 0.06));
    const auto scene = make_scene(plan, {});
    REQUIRE(run(*scene, 3.0));
    CHECK(total_load(*scene) / (scene->mass() * 9.81) == Approx(1.0).margin(1e-3));
    CHECK(scene->part_load(3) > 0.0);
}

TEST_CASE("nothing is felt in free fall that begins in motion", "[dynamics][forces]") {
    Environment air;
    air.has_ground = false;
    RandomStream random(stream_seed({4, 74}));
    const auto scene = make_scene(measured(random_tree(random, 5, 0.0, 20.0, 0.0)), air);
    SceneMotion motion = scene->motion();
    motion.speeds[motion.speeds.size() - 2] = 3.0;
    motion.speeds[motion.speeds.size() - 1] = -2.0;
    REQUIRE(scene->begin_at(motion));
    REQUIRE(run(*scene, kTestTick));
    for (std::size_t part = 0; part < scene->part_count(); ++part)
        CHECK(scene->part_specific_force(part).norm() <= 1e-9);
}

TEST_CASE("in free fall nothing is felt", "[dynamics][forces]") {
    Environment air;
    air.has_ground = false;
    RandomStream random(stream_seed({4, 73}));
    for (const int parts : {1, 5}) {
        const auto scene = make_scene(measured(random_tree(random, parts, 0.0, 20.0, 0.0)), air);
        for (int tick = 0; tick < 60; ++tick) {
            REQUIRE(run(*scene, kTestTick));
            for (std::size_t part = 0; part < scene->part_count(); ++part) {
                REQUIRE(scene->part_specific_force(part).norm() <= 1e-9);
                REQUIRE(scene->part_load(part) == 0.0);
            }
        }
    }
}

TEST_CASE("loads account for the momentum that the ground gives, impacts included",
          "[dynamics][forces]") {
    Environment world;
    world.elasticity = 0.5;
    const auto scene = make_scene(measured(one_box(0.3, 0.1, 0.0, 1.0, 0.4)), world);
    double impulse = 0.0;
    double heaviest = 0.0;
    for (int tick = 0; tick < 180; ++tick) {
        REQUIRE(run(*scene, kTestTick));
        impulse += scene->part_load(0) * kTestTick;
        heaviest = std::fmax(heaviest, scene->part_load(0));
    }
    const double weight = scene->mass() * 9.81;
    const double given =
        scene->mass() * scene->center_of_mass_velocity().y() + weight * 180 * kTestTick;
    CHECK(impulse == Approx(given).epsilon(1e-3));
    CHECK(heaviest > 5.0 * weight);
}

TEST_CASE("both of two boxes that press on each other bear the load", "[dynamics][forces]") {
    BodyPlan plan = one_box(0.3, 0.1, 0.0, 0.101);
    plan.parts.push_back(one_box(0.2, 0.1, 0.0, 0.33).parts.front());
    const auto scene = make_scene(measured(plan), {});
    REQUIRE(run(*scene, 2.0));
    const double lower = 4.0 * 0.3 * 0.1 * 9.81;
    const double upper = 4.0 * 0.2 * 0.1 * 9.81;
    CHECK(scene->part_load(1) == Approx(upper).epsilon(1e-3));
    CHECK(scene->part_load(0) == Approx(lower + 2.0 * upper).epsilon(1e-3));
}

TEST_CASE("measuring forces changes no bit, and without it they read 0", "[dynamics][forces]") {
    RandomStream random(stream_seed({5, 73}));
    const BodyPlan plan = random_tree(random, 6, 0.3, 20.0, 0.0);
    std::uint64_t digests[2] = {0, 0};
    for (const bool measures : {false, true}) {
        const auto scene = make_scene(measures ? measured(plan) : plan, {});
        stand_on_ground(*scene);
        for (int tick = 0; tick < 120; ++tick) {
            flail(*scene, plan, 2.0);
            REQUIRE(run(*scene, kTestTick));
        }
        Hash64 digest;
        scene->add_to_digest(digest);
        digests[measures ? 1 : 0] = digest.value();
        CHECK((total_load(*scene) > 0.0) == measures);
        CHECK((scene->part_specific_force(0).norm() > 0.0) == measures);
    }
    CHECK(digests[0] == digests[1]);
}

TEST_CASE("a restored moment feels what it felt", "[dynamics][forces]") {
    const auto scene = make_scene(measured(one_box(0.3, 0.1, 0.0, 0.101)), {});
    REQUIRE(run(*scene, 0.5));
    const Vec3 force = scene->part_specific_force(0);
    const double load = scene->part_load(0);
    const auto moment = scene->save();
    scene->translate(Vec3(0.0, 2.0, 0.0));
    REQUIRE(run(*scene, 0.1));
    CHECK(scene->part_load(0) == 0.0);
    scene->restore(*moment);
    CHECK(scene->part_specific_force(0) == force);
    CHECK(scene->part_load(0) == load);
}

TEST_CASE("a part that nobody asks about reads 0", "[dynamics][forces]") {
    BodyPlan plan = chain(4, 1.0, 0.0, 0.06);
    plan.parts[1].measures_forces = true;
    const auto scene = make_scene(plan, {});
    REQUIRE(run(*scene, 1.0));
    for (std::size_t part = 0; part < 4; ++part) {
        CHECK((scene->part_load(part) > 0.0) == (part == 1));
        CHECK((scene->part_specific_force(part).norm() > 0.0) == (part == 1));
    }
}
