#include "planar/rig.h"
#include "support/catch.h"

#include <cmath>
#include <vector>

using namespace cambrian;

namespace {

// A heavy base with one light link, in empty space.
BodyPlan base_and_link(double max_effort, MotorMode mode = MotorMode::kPosition) {
    BodyPlan plan = one_box(2.0, 2.0, 0.0, 0.0);
    PlannedPart& link = attach(plan, 0, Vec3(2.0, 0.0, 0.0), 0.0, kRotaryJoint, 0.3, 0.05);
    link.limit_low = -3.0;
    link.limit_high = 3.0;
    link.max_effort = max_effort;
    link.motor_mode = mode;
    return plan;
}

// Returns the inertia, in kg m^2, against which the joint of two hinged bodies in line acts.
double effective_inertia(const PlanarModel& model) {
    const double reduced = model.mass[0] * model.mass[1] / model.total_mass;
    const double a = model.parent_anchor_x[1];
    const double b = -model.child_anchor_x[1];
    const double xx = model.inertia[0] + reduced * a * a;
    const double yy = model.inertia[1] + reduced * b * b;
    const double xy = reduced * a * b;
    return (xx * yy - xy * xy) / (xx + yy + 2.0 * xy);
}

}  // namespace

TEST_CASE("a joint feels the reduced inertia of both its bodies", "[dynamics][motor]") {
    const auto model = build_planar_model(base_and_link(1.0), 1.0);
    REQUIRE(model);
    CHECK(model->effective_inertia[1] == Approx(effective_inertia(*model)).epsilon(1e-12));
}

TEST_CASE("a motor approaches its target critically damped", "[dynamics][motor]") {
    SceneSettings settings;
    settings.tolerance = 1e-7;
    const auto scene = make_scene(base_and_link(1e6), empty_space(), settings);
    scene->set_target(1, 1e-3);
    // The target ramps over the first tick; afterwards phi = y - (A + B t) exp(-w t).
    REQUIRE(run(*scene, kTestTick));
    const double w = settings.motor_frequency;
    const double a = 1e-3 - scene->joint_coordinate(1);
    const double b = w * a - scene->joint_rate(1);
    REQUIRE(run(*scene, 0.1));
    const double expected = 1e-3 - (a + b * 0.1) * exponential(-w * 0.1);
    CHECK(scene->joint_coordinate(1) == Approx(expected).epsilon(1e-3));
}

TEST_CASE("a motor asks for no more than its speed limit", "[dynamics][motor]") {
    const auto scene = make_scene(base_and_link(1e6), empty_space());
    scene->set_target(1, 3.0);
    REQUIRE(run(*scene, 0.25));
    CHECK(scene->joint_rate(1) == Approx(6.0).epsilon(1e-2));
    REQUIRE(run(*scene, 2.0));
    CHECK(scene->joint_coordinate(1) == Approx(3.0).epsilon(1e-4));
}

TEST_CASE("a motor gives no more than its effort cap", "[dynamics][motor]") {
    const auto scene = make_scene(base_and_link(0.01), empty_space());
    scene->set_target(1, 3.0);
    REQUIRE(run(*scene, 4 * kTestTick));
    CHECK(scene->joint_effort(1) == 0.01);
    const double before = scene->joint_rate(1);
    REQUIRE(run(*scene, kTestTick));
    const auto model = build_planar_model(base_and_link(0.01), 1.0);
    const double expected = 0.01 / model->effective_inertia[1] * kTestTick;
    CHECK(scene->joint_rate(1) - before == Approx(expected).epsilon(1e-2));
}

TEST_CASE("a target is approached linearly over one tick", "[dynamics][motor]") {
    const auto scene = make_scene(base_and_link(0.01, MotorMode::kTorque), empty_space());
    const auto model = build_planar_model(base_and_link(0.01), 1.0);
    scene->set_target(1, 1.0);
    REQUIRE(run(*scene, kTestTick));
    const double full = 0.01 / model->effective_inertia[1] * kTestTick;
    CHECK(scene->joint_rate(1) == Approx(0.5 * full).epsilon(1e-4));
    REQUIRE(run(*scene, kTestTick));
    CHECK(scene->joint_rate(1) == Approx(1.5 * full).epsilon(1e-4));
}

TEST_CASE("velocity mode holds a rate", "[dynamics][motor]") {
    const auto scene = make_scene(base_and_link(1e6, MotorMode::kVelocity), empty_space());
    scene->set_target(1, -2.0);
    REQUIRE(run(*scene, 0.5));
    CHECK(scene->joint_rate(1) == Approx(-2.0).epsilon(1e-3));
}

TEST_CASE("targets of position motors stay inside the limits", "[dynamics][motor]") {
    const auto scene = make_scene(base_and_link(1.0), empty_space());
    scene->set_target(1, 5.0);
    CHECK(scene->target(1) == 3.0);
    scene->set_target(0, 5.0);
    CHECK(scene->target(0) == 0.0);
}

TEST_CASE("a link swings with the period of its own pendulum and its base's recoil",
          "[dynamics][motor]") {
    // The period is tested on a link that hangs from a base on the ground, since a free pair does
    // not swing in a uniform field. The base is so heavy and frictionless that it recoils freely:
    // w^2 = m g b / (I + mu b^2), where mu is the reduced mass. The swinging force comes from the
    // ground, so the contact step limits the error: 8.8e-5 rad at 1/60 s, 1.2e-5 at 1/120 s, 1.9e-6
    // at 1/240 s.
    BodyPlan plan = one_box(0.5, 0.3, 0.0, 0.3 + kRestingGap);
    PlannedPart& link =
        attach(plan, 0, Vec3(0.0, 0.2, 0.0), -kPi / 2 + 0.01, kRotaryJoint, 0.08, 0.02);
    link.limit_low = -1.0;
    link.limit_high = 1.0;
    Environment environment;
    environment.friction = 0.0;
    Rig rig(plan, environment, "bogacki-shampine", 1e-6, 1.0 / 240);
    rig.begin();
    const double m = rig.model.mass[1];
    const double b = 0.08;
    const double reduced = m * rig.model.mass[0] / rig.model.total_mass;
    const double w = std::sqrt(m * 9.81 * b / (rig.model.inertia[1] + reduced * b * b));
    const double periods = 5.0;
    const double duration = periods * 2.0 * kPi / w;
    const int ticks = static_cast<int>(duration / kTestTick);
    REQUIRE(rig.run(ticks * kTestTick));
    const double phase = w * ticks * kTestTick;
    const double angle = rig.state.motion.position[1] + kPi / 2;
    CHECK(angle == Approx(0.01 * cosine(phase)).margin(4e-6));
}

TEST_CASE("motors that are off give no effort, whatever their targets", "[dynamics][motor]") {
    for (const MotorMode mode : {MotorMode::kPosition, MotorMode::kVelocity, MotorMode::kTorque}) {
        const auto scene = make_scene(base_and_link(10.0, mode), empty_space());
        scene->set_motors_off(true);
        scene->set_target(1, 1.0);
        REQUIRE(run(*scene, 0.1));
        CHECK(scene->joint_coordinate(1) == 0.0);
        CHECK(scene->audit().gross_motor_work == 0.0);
        scene->set_motors_off(false);
        REQUIRE(run(*scene, 0.1));
        CHECK(scene->joint_coordinate(1) > 0.01);
    }
}

TEST_CASE("a body with motors off slides without friction", "[dynamics][motor]") {
    const auto scene = make_scene(one_box(0.6, 0.2, 0.0, 0.1), Environment{});
    scene->set_motors_off(true);
    REQUIRE(run(*scene, 0.1));
    scene->pull(0, Vec3::Zero(), Vec3(10.0, 0.0, 0.0));
    REQUIRE(run(*scene, kTestTick));
    const double speed = scene->center_of_mass_velocity().x();
    CHECK(speed > 0.3);
    REQUIRE(run(*scene, 0.3));
    CHECK(scene->center_of_mass_velocity().x() == Approx(speed).epsilon(1e-9));
    scene->set_motors_off(false);
    REQUIRE(run(*scene, 0.5));
    CHECK(scene->center_of_mass_velocity().x() == Approx(0.0).margin(1e-3));
}
