// Bodies that meet boxes which never move.
#include "planar/bodies.h"
#include "support/catch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace cambrian;

namespace {

FixedBox upright_wall(double x) {
    return box_around({x, -1.0, 0.0}, {x, 1.0, 0.0}, 0.1);
}

void give_speed(PhysicsScene& scene, double x, double y, double spin = 0.0) {
    SceneMotion motion = scene.motion();
    motion.speeds[motion.speeds.size() - 2] = x;
    motion.speeds[motion.speeds.size() - 1] = y;
    motion.speeds[0] = spin;
    REQUIRE(scene.begin_at(motion));
}

}  // namespace

TEST_CASE("a brick bounces off a fixed box with the elasticity of the environment",
          "[dynamics][fixed_box]") {
    Environment environment = empty_space();
    environment.elasticity = 0.5;
    const auto scene = make_scene(one_box(0.2, 0.1, 0.0, 0.0), environment);
    const std::vector<FixedBox> walls = {upright_wall(1.0)};
    scene->set_fixed_boxes(walls);
    give_speed(*scene, 2.0, 0.0);
    std::vector<SceneImpact> impacts;
    std::size_t heard = 0;
    for (int tick = 0; tick < 60; ++tick) {
        REQUIRE(run(*scene, kTestTick));
        CHECK(scene->bounds().high.x() < 0.901);
        scene->list_impacts(impacts);
        heard += impacts.size();
    }
    CHECK(heard == 1);
    CHECK(scene->center_of_mass_velocity().x() == Approx(-1.0).epsilon(1e-6));
    CHECK(std::fabs(scene->audit().energy_residual) < 1e-6);
    scene->set_fixed_boxes({});
    give_speed(*scene, 2.0, 0.0);
    REQUIRE(run(*scene, 1.0));
    CHECK(scene->center_of_mass().x() > 1.5);
}

TEST_CASE("bodies of any shape do not pass through a slanted wall or its end",
          "[dynamics][fixed_box]") {
    RandomStream random(stream_seed({77}));
    int touched = 0;
    for (int round = 0; round < 24; ++round) {
        BodyPlan plan = random_tree(random, 4, 0.2, 1.0, 0.0);
        const bool deforms = round % 3 == 0;
        if (deforms) make_deformable(plan.parts[0], -0.3, 0.3);
        const auto scene = make_scene(plan, empty_space());
        const double turn = random.uniform(-0.8, 0.8);
        const Vec3 along(-std::sin(turn), std::cos(turn), 0.0);
        const Vec3 middle(2.5, round % 2 == 0 ? 0.0 : 3.0, 0.0);
        const std::vector<FixedBox> walls = {
            box_around(middle - 3.0 * along, middle + 3.0 * along, 0.1)};
        scene->translate(-scene->center_of_mass());
        scene->set_fixed_boxes(walls);
        give_speed(*scene, 5.0, 0.0, random.uniform(-3.0, 3.0));
        std::vector<SceneContact> contacts;
        for (int tick = 0; tick < 90; ++tick) {
            flail(*scene, plan, 2.0);
            REQUIRE(run(*scene, kTestTick));
            scene->list_contacts(contacts);
            touched += contacts.empty() ? 0 : 1;
            if (round % 2 == 0) {
                // The side of the wall on which it began.
                const Vec3 normal(along.y(), -along.x(), 0.0);
                CHECK((scene->center_of_mass() - middle).dot(normal) < 0.0);
            }
        }
        CHECK(scene->audit().max_penetration < 0.02);
    }
    CHECK(touched > 100);
}

TEST_CASE("scenes that are joined meet fixed boxes as each alone does", "[dynamics][fixed_box]") {
    const std::vector<FixedBox> walls = {upright_wall(1.0)};
    const auto alone = make_scene(one_box(0.2, 0.1, 0.0, 0.0), empty_space());
    const auto first = make_scene(one_box(0.2, 0.1, 0.0, 0.0), empty_space());
    const auto second = make_scene(one_box(0.2, 0.1, 0.0, 5.0), empty_space());
    for (PhysicsScene* scene : {alone.get(), first.get(), second.get()}) {
        scene->set_fixed_boxes(walls);
        give_speed(*scene, 2.0, 0.3);
    }
    const std::array<PhysicsScene*, 2> both = {first.get(), second.get()};
    const auto joined = planar_scene_kind().join(both);
    const auto workspace = first->take_workspace();
    for (int tick = 0; tick < 90; ++tick) {
        REQUIRE(run(*alone, kTestTick));
        REQUIRE(joined->advance(both, kTestTick, *workspace) == SceneStatus::kRunning);
        CHECK(first->bounds().high.x() < 0.901);
    }
    CHECK(second->center_of_mass().x() > 1.2);
    CHECK((first->center_of_mass() - alone->center_of_mass()).norm() < 1e-2);
    CHECK(first->center_of_mass().x() < 0.8);
}

TEST_CASE("a wall far away changes no bit", "[dynamics][fixed_box]") {
    const std::vector<FixedBox> walls(kMostFixedBoxes, upright_wall(9.0));
    const BodyPlan plan = chain(4, 1.0);
    const auto free = make_scene(plan, open_water());
    const auto walled = make_scene(plan, open_water());
    walled->set_fixed_boxes(walls);
    for (int tick = 0; tick < 120; ++tick) {
        for (PhysicsScene* scene : {free.get(), walled.get()}) {
            flail(*scene, plan, 2.0);
            REQUIRE(run(*scene, kTestTick));
        }
    }
    CHECK(free->motion().positions == walled->motion().positions);
}
