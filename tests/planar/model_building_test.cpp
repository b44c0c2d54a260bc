#include "planar/model_building.h"

#include "planar/bodies.h"
#include "planar/island/joined_model.h"
#include "planar/refused_plan.h"
#include "support/catch.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace cambrian;
using test::refused;

namespace {

bool may_collide(const PlanarModel& model, int a, int b) {
    for (const PartPair& pair : model.colliding_pairs) {
        if (pair.first == a && pair.second == b) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("rigid joints weld parts into one body", "[dynamics][model]") {
    BodyPlan plan = one_box(0.2, 0.1, 1.0, 2.0);
    attach(plan, 0, Vec3(0.2, 0.0, 0.0), 0.0, kRigidJoint, 0.2, 0.1);
    const auto model = build_planar_model(plan, 2.0);
    REQUIRE(model);
    REQUIRE(model->body_count == 1);
    // Two welded boxes end to end are equal to one box of twice the length.
    CHECK(model->mass[0] == Approx(2.0 * 0.8 * 0.2));
    CHECK(model->inertia[0] == Approx(model->mass[0] * (0.4 * 0.4 + 0.1 * 0.1) / 3.0));
    CHECK(model->rest_center_x[0] == Approx(1.2));
    CHECK(model->part_x[0] == Approx(-0.2));
    CHECK(model->part_x[1] == Approx(0.2));
}

TEST_CASE("bodies are numbered depth first", "[dynamics][model]") {
    BodyPlan plan = one_box(0.2, 0.1, 0.0, 0.0);
    attach(plan, 0, Vec3(0.2, 0.0, 0.0), 0.0, kRotaryJoint);
    attach(plan, 0, Vec3(-0.2, 0.0, 0.0), kPi, kRotaryJoint);
    attach(plan, 1, Vec3(0.2, 0.0, 0.0), 0.0, kRotaryJoint);
    const auto model = build_planar_model(plan, 1.0);
    REQUIRE(model);
    CHECK(model->part_body[3] == 2);
    CHECK(model->parent[2] == 1);
    CHECK(model->part_body[2] == 3);
    CHECK(model->parent[3] == 0);
}

TEST_CASE("bodies are listed by depth, and by number at the same depth", "[dynamics][model]") {
    RandomStream random(stream_seed({16, 1}));
    for (int round = 0; round < 300; ++round) {
        const int parts = 1 + round % 30;
        const PlanarModel first =
            *build_planar_model(random_tree(random, parts, 0.3, 1.0, 0.2), 1.0);
        const PlanarModel second = *build_planar_model(random_tree(random, 20, 0.3, 1.0, 0.2), 1.0);
        const PlanarModel joined = join_models(std::vector{&first, &second});
        for (const PlanarModel* model : {&first, &joined}) {
            const auto depth = [&](int body) {
                int steps = 0;
                for (; model->parent[body] >= 0; body = model->parent[body])
                    ++steps;
                return steps;
            };
            std::vector<std::pair<int, int>> expected;
            for (int body = 0; body < model->body_count; ++body)
                expected.emplace_back(depth(body), body);
            std::sort(expected.begin(), expected.end());
            for (std::size_t at = 0; at < expected.size(); ++at)
                REQUIRE(model->by_depth[at] == expected[at].second);
        }
    }
}

TEST_CASE("the rest pose of the model is that of the plan", "[dynamics][model]") {
    RandomStream random(stream_seed({31}));
    for (int round = 0; round < 50; ++round) {
        BodyPlan plan = random_tree(random, 10, 0.3, 1.0, 1.0);
        for (std::size_t i = 1; i < plan.parts.size(); i += 3)
            plan.parts[i].motion = kRigidJoint;
        const auto scene = make_scene(plan, empty_space());
        for (std::size_t i = 0; i < plan.parts.size(); ++i) {
            const Pose pose = scene->part_pose(i);
            CHECK((pose.position - plan.parts[i].rest_pose.position).norm() < 1e-12);
            CHECK(pose.orientation.angularDistance(plan.parts[i].rest_pose.orientation) < 1e-7);
            CHECK(scene->joint_coordinate(i) == Approx(0.0).margin(1e-12));
        }
    }
}

TEST_CASE("joint coordinates are listed in the order of the parts asked for", "[dynamics][model]") {
    RandomStream random(stream_seed({32}));
    BodyPlan plan = random_tree(random, 10, 0.3, 1.0, 1.0);
    plan.parts[4].motion = kRigidJoint;
    const auto scene = make_scene(plan, empty_space());
    for (std::size_t part = 1; part < plan.parts.size(); ++part)
        scene->set_target(part, 0.1 * static_cast<double>(part));
    for (int tick = 0; tick < 30; ++tick)
        scene->advance(1.0 / 60.0);
    const std::vector<JointDegree> degrees = {{9, 0}, {4, 0}, {1, 0}, {0, 0}, {7, 0}};
    std::vector<double> coordinates(degrees.size(), -1.0);
    scene->list_joint_coordinates(degrees, coordinates);
    for (std::size_t i = 0; i < degrees.size(); ++i)
        CHECK(coordinates[i] == scene->joint_coordinate(degrees[i].part));
    CHECK(coordinates[0] != 0.0);
    CHECK(coordinates[0] != coordinates[2]);
    CHECK(coordinates[1] == 0.0);
}

TEST_CASE("jointed, overlapping and welded boxes never collide", "[dynamics][model]") {
    BodyPlan plan = chain(4, 1.0);
    attach(plan, 0, Vec3(0.0, 0.05, 0.0), 0.0, kRotaryJoint, 0.3, 0.04);
    const auto model = build_planar_model(plan, 1.0);
    REQUIRE(model);
    CHECK(!may_collide(*model, 0, 1));  // they share a joint
    CHECK(may_collide(*model, 0, 2));   // they share no joint
    CHECK(may_collide(*model, 0, 3));
    CHECK(!may_collide(*model, 1, 4));  // they overlap at rest
    plan.parts[3].motion = kRigidJoint;
    const auto welded = build_planar_model(plan, 1.0);
    CHECK(!may_collide(*welded, 1, 3));  // now one body with part 2
}

TEST_CASE("bodies that physics cannot move are refused by name", "[dynamics][model]") {
    CHECK(refused({}, "no parts"));
    BodyPlan thin = one_box(0.2, 0.005, 0.0, 0.0);
    CHECK(refused(thin, "part 0: thinner"));
    BodyPlan light = one_box(4.0, 4.0, 0.0, 0.0);
    attach(light, 0, Vec3(4.0, 0.0, 0.0), 0.0, kRotaryJoint, 0.02, 0.01);
    CHECK(refused(light, "part 1: lighter"));
    BodyPlan infinite = chain(2, 1.0);
    infinite.parts[1].anchor_in_parent.x() = std::numeric_limits<double>::infinity();
    CHECK(refused(infinite, "part 1: a number is not finite"));
    CHECK(refused(chain(33, 1.0), "over 32 moving bodies"));
    BodyPlan orphan = chain(3, 1.0);
    orphan.parts[2].parent = 2;
    CHECK(refused(orphan, "part 2: part 0 is a root"));
    BodyPlan swapped = chain(2, 1.0);
    swapped.parts[1].limit_low = 2.0;
    CHECK(refused(swapped, "part 1: limits"));
}

TEST_CASE("an unknown integrator is refused by name", "[dynamics][model]") {
    SceneSettings settings;
    settings.integrator = "bogacki-shampin";
    const auto scene = planar_scene_kind().make(chain(2, 1.0), {}, settings);
    REQUIRE(!scene);
    CHECK(scene.error().message.find("bogacki-shampine") != std::string::npos);
}
