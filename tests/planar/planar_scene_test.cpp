#include "planar/bodies.h"
#include "support/catch.h"

#include <cmath>
#include <vector>

using namespace cambrian;

TEST_CASE("the ground carries the weight of what lies on it", "[dynamics][scene]") {
    const auto scene = make_scene(one_box(0.3, 0.1, 0.0, 0.2), {});
    REQUIRE(run(*scene, 2.0));
    std::vector<SceneContact> contacts;
    scene->list_contacts(contacts);
    REQUIRE(contacts.size() == 2);
    CHECK(contacts[0].force + contacts[1].force == Approx(scene->mass() * 9.81).epsilon(1e-6));
    CHECK(contacts[0].normal.y() == 1.0);
    CHECK(std::fabs(contacts[0].point.y()) < 1e-3);
}

TEST_CASE("only the face on the ground feels touch", "[dynamics][scene]") {
    const auto scene = make_scene(one_box(0.3, 0.1, 0.0, 0.2, kPi), {});
    CHECK(!scene->face_touched(0, Face::kLeft));
    REQUIRE(run(*scene, 1.0));
    CHECK(scene->face_touched(0, Face::kLeft));  // upside down
    CHECK(!scene->face_touched(0, Face::kRight));
    CHECK(!scene->face_touched(0, Face::kDistal));
    CHECK(!scene->face_touched(0, Face::kProximal));
}

TEST_CASE("a pull accelerates as its force says, for one tick", "[dynamics][scene]") {
    const auto scene = make_scene(one_box(0.3, 0.1, 0.0, 0.0), empty_space());
    scene->pull(0, Vec3::Zero(), Vec3(2.0, 0.0, 0.0));
    REQUIRE(run(*scene, kTestTick));
    const double speed = 2.0 / scene->mass() * kTestTick;
    CHECK(scene->center_of_mass_velocity().x() == Approx(speed).epsilon(1e-12));
    REQUIRE(run(*scene, kTestTick));
    CHECK(scene->center_of_mass_velocity().x() == Approx(speed).epsilon(1e-12));
    CHECK(std::fabs(scene->audit().energy_residual) < 1e-12);
}

TEST_CASE("a pull off the centre turns", "[dynamics][scene]") {
    const auto scene = make_scene(one_box(0.3, 0.1, 0.0, 0.0), empty_space());
    scene->pull(0, Vec3(0.3, 0.0, 0.0), Vec3(0.0, 0.01, 0.0));
    REQUIRE(run(*scene, kTestTick));
    const double inertia = scene->mass() * (0.09 + 0.01) / 3.0;
    CHECK(scene->part_twist(0).angular.z() ==
          Approx(0.3 * 0.01 / inertia * kTestTick).epsilon(1e-4));
}

TEST_CASE("translation moves every part and keeps the audit balanced", "[dynamics][scene]") {
    const BodyPlan plan = chain(3, 1.0, 0.0, 2.0);
    const auto scene = make_scene(plan, {});
    REQUIRE(run(*scene, 0.2));
    const Vec3 before = scene->part_pose(2).position;
    scene->translate(Vec3(1.0, 5.0, 0.0));
    CHECK((scene->part_pose(2).position - before - Vec3(1.0, 5.0, 0.0)).norm() < 1e-12);
    REQUIRE(run(*scene, 0.2));
    CHECK(std::fabs(scene->audit().energy_residual) < 1e-9);
}

TEST_CASE("a changed environment acts at once and keeps the audit balanced", "[dynamics][scene]") {
    const auto scene = make_scene(one_box(0.3, 0.1, 0.0, 5.0), {});
    REQUIRE(run(*scene, 0.5));
    const double speed = scene->center_of_mass_velocity().y();
    Environment moon;
    moon.gravity = 1.6;
    moon.density = 3.0;
    scene->set_environment(moon);
    CHECK(scene->mass() == Approx(3.0 * 0.12));
    REQUIRE(run(*scene, 0.5));
    CHECK(scene->center_of_mass_velocity().y() - speed == Approx(-0.8).epsilon(1e-9));
    CHECK(std::fabs(scene->audit().energy_residual) < 1e-9);
}

TEST_CASE("a state restored into another environment keeps the audit balanced",
          "[dynamics][scene]") {
    Environment moon;
    moon.gravity = 1.6;
    moon.gravity_direction = -70.0;
    moon.density = 3.0;
    const BodyPlan plan = chain(3, 1.0, 0.0, 5.0);
    const auto away = make_scene(plan, moon);
    REQUIRE(run(*away, 0.5));
    const auto state = away->save();
    const auto scene = make_scene(plan, {});
    scene->restore(*state);
    CHECK(scene->energy() > 0.0);
    REQUIRE(run(*scene, 0.25));
    CHECK(std::fabs(scene->audit().energy_residual) < 1e-9);
    away->set_environment({});
    away->restore(*state);
    REQUIRE(run(*away, 0.25));
    CHECK(std::fabs(away->audit().energy_residual) < 1e-9);
}

TEST_CASE("views of welded parts move with their body", "[dynamics][scene]") {
    BodyPlan plan = one_box(0.2, 0.1, 0.0, 0.0);
    attach(plan, 0, Vec3(0.2, 0.0, 0.0), 0.7, kRigidJoint);
    const auto scene = make_scene(plan, empty_space());
    scene->pull(1, Vec3(0.1, 0.0, 0.0), Vec3(1.0, 2.0, 0.0));
    REQUIRE(run(*scene, 1.0));
    const Pose root = scene->part_pose(0);
    const Pose arm = scene->part_pose(1);
    const double turn = planar_angle(arm) - planar_angle(root);
    CHECK(std::fabs(std::remainder(turn - 0.7, 2 * kPi)) < 1e-9);
    CHECK((transform(root, Vec3(0.2, 0.0, 0.0)) - transform(arm, Vec3(-0.2, 0.0, 0.0))).norm() <
          1e-12);
    const Vec3 offset = arm.position - root.position;
    const Twist twist = scene->part_twist(0);
    const Vec3 expected = twist.linear + twist.angular.cross(offset);
    CHECK((scene->part_twist(1).linear - expected).norm() < 1e-12);
}

TEST_CASE("a scene that diverges stops and says so", "[dynamics][scene]") {
    Environment environment;
    environment.has_ground = false;
    environment.gravity = 1e6;
    const auto scene = make_scene(one_box(0.3, 0.1, 0.0, 0.0), environment);
    CHECK(!run(*scene, 1.0));
    CHECK(scene->status() == SceneStatus::kInvalid);
    const double time = scene->time();
    CHECK(scene->advance(kTestTick) == SceneStatus::kInvalid);
    CHECK(scene->time() == time);
}

TEST_CASE("motion too stiff for its budget leaves the scene as it was", "[dynamics][scene]") {
    Environment treacle = empty_space();
    treacle.gravity = 9.81;
    treacle.viscosity_linear = 1e4;
    treacle.density = 1e-3;
    const auto scene = make_scene(chain(3, 1.0, 0.0, 2.0), treacle);
    const Vec3 center = scene->center_of_mass();
    CHECK(!run(*scene, 1.0));
    CHECK(scene->status() == SceneStatus::kOverBudget);
    CHECK(scene->audit().evaluations <= 60000);
    CHECK((scene->center_of_mass() - center).norm() < 1e-3);
    CHECK(std::isfinite(scene->audit().energy_residual));
}

TEST_CASE("a restarted audit counts from now", "[dynamics][scene]") {
    const auto scene = make_scene(one_box(0.3, 0.1, 0.0, 1.0), {});
    REQUIRE(run(*scene, 1.0));
    CHECK(scene->audit().impulse_work < 0.0);
    scene->restart_audit();
    REQUIRE(run(*scene, 1.0));
    CHECK(scene->audit().impulse_work == 0.0);
    CHECK(std::fabs(scene->audit().energy_residual) < 1e-9);
}
