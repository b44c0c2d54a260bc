// Closed loops, which only the reference integrator supports.

#include "dynamics/articulated/least_squares_dynamics.h"
#include "dynamics/articulated/loop_closure.h"
#include "dynamics/model/loop_joints.h"
#include "dynamics/refused_plan.h"
#include "dynamics/rig.h"
#include "support/catch.h"

#include <cmath>
#include <limits>
#include <string>

using namespace cambrian;
using test::refused;

namespace {

constexpr double kHalfLength = 0.5;  // m
constexpr double kHalfWidth = 0.05;  // m
constexpr double kFree = 1e6;        // rad; stops that are never reached
const std::string kReference = "least-squares";
const Vec3 kDistal(kHalfLength, 0.0, 0.0);

// Returns rods end to end, each at an angle to the one before; the joints are at the ends' centres.
BodyPlan rods(const std::vector<double>& turns, double angle, double limit, double height,
              JointMotion joint = kRotaryJoint) {
    BodyPlan plan = one_box(kHalfLength, kHalfWidth, 0.0, height, angle);
    int last = 0;
    for (const double turn : turns) {
        PlannedPart& rod = attach(plan, last++, kDistal, turn, joint, kHalfLength, kHalfWidth);
        rod.limit_low = -limit;
        rod.limit_high = limit;
    }
    return plan;
}

// Returns the same rods with the last one's free end closed to the first one's.
BodyPlan ring(const std::vector<double>& turns, double angle = 0.0, double limit = kFree,
              double height = 0.0) {
    BodyPlan plan = rods(turns, angle, limit, height);
    plan.loop_joints = {{static_cast<int>(turns.size()), 0, kDistal, -kDistal}};
    return plan;
}

// Returns four equal rods at the angles -opening, opening, pi - opening, pi + opening.
BodyPlan rhombus(double opening, double limit = kFree) {
    return ring({2.0 * opening, kPi - 2.0 * opening, 2.0 * opening}, -opening, limit);
}

std::vector<double> regular_turns(int corners) {
    return std::vector<double>(static_cast<std::size_t>(corners) - 1, 2.0 * kPi / corners);
}

Environment airless(double gravity) {
    Environment environment = empty_space();
    environment.gravity = gravity;
    return environment;
}

// Makes the rhombus open at this rate.
void flap(Rig& rig, double rate) {
    for (int i = 0; i < 4; ++i)
        rig.state.motion.speed[i] = i % 2 == 0 ? -rate : rate;
}

double gap_of(const PlanarModel& model, const Kinematics& k) {
    double widest = 0.0;
    for (const LoopJoint& joint : model.loop_joints)
        widest = std::fmax(widest, loop_gap(k, joint, loop_arms(k, joint)).norm());
    return widest;
}

double gap_of(const Rig& rig) {
    return gap_of(rig.model, rig.state.cache().kinematics);
}

BodyPlan closed_badly(const PlannedLoopJoint& joint) {
    BodyPlan plan = rhombus(0.6);
    plan.loop_joints.push_back(joint);
    return plan;
}

}  // namespace

TEST_CASE("accelerations of loops agree with dense least squares", "[dynamics][loops]") {
    RandomStream random(stream_seed({51}));
    const auto model = build_planar_model(ring(regular_turns(5)), 1.0);
    REQUIRE(model);
    for (int round = 0; round < 50; ++round) {
        Motion motion = rest_motion(*model);
        EvaluationCache cache = {};
        MotionRate rate;
        Forcing forcing;
        forcing.medium = {1.0, -9.81, 0.5, 0.2};
        for (int c = 0; c < coordinate_count(*model); ++c) {
            motion.position[c] += 0.1 * random.gauss();
            motion.speed[c] = 4.0 * random.gauss();
        }
        for (int newton = 0; newton < 8; ++newton) {
            evaluate_accelerations(*model, forcing, motion, {}, cache, rate);
            LoopClosure(*model, cache.kinematics, cache.factors).close_drift(motion);
        }
        evaluate_accelerations(*model, forcing, motion, {}, cache, rate);
        LeastSquaresDynamics reference(*model, 1.0 / 20);
        const Eigen::VectorXd dense = reference.solve(cache.kinematics, cache.loads);
        CHECK(reference.deviation().norm() < 1e-12);
        Eigen::VectorXd closed(dense.size());
        for (Eigen::Index i = 0; i < model->body_count; ++i)
            closed.segment<3>(3 * i) << cache.response.x[i], cache.response.y[i],
                cache.response.spin[i];
        CHECK((closed - dense).norm() < 1e-9 * dense.norm());
    }
}

// The kinetic energy is T = 2 (m a^2 + I) rate^2 for any opening, so the rate is constant.
TEST_CASE("a free rhombus opens at a constant rate", "[dynamics][loops]") {
    const double opening = 0.4;
    const double rate = 0.5;
    Rig rig(rhombus(opening), empty_space(), kReference);
    flap(rig, rate);
    rig.begin();
    const double mass = rig.model.mass[0];
    const double exact =
        2.0 * (mass * kHalfLength * kHalfLength + rig.model.inertia[0]) * rate * rate;
    CHECK(rig.energy() == Approx(exact).epsilon(1e-12));
    for (int tick = 1; tick <= 120; ++tick) {
        REQUIRE(rig.run(kTestTick));
        const Motion& motion = rig.state.motion;
        CHECK(motion.position[1] == Approx(opening + rate * tick * kTestTick).epsilon(1e-7));
        CHECK(motion.speed[1] == Approx(rate).epsilon(1e-7));
        CHECK(motion.speed[0] == Approx(-rate).epsilon(1e-7));
        CHECK(rig.energy() == Approx(exact).epsilon(1e-7));
        CHECK(gap_of(rig) < 1e-12);
    }
}

TEST_CASE("a loop keeps energy and angular momentum", "[dynamics][loops]") {
    Rig rig(ring(regular_turns(5)), empty_space(), kReference);
    rig.model.colliding_pairs.clear();
    rig.state.motion.speed[0] = 3.0;
    rig.state.motion.speed[2] = -4.0;
    rig.begin();
    LoopClosure(rig.model, rig.state.cache().kinematics, rig.state.cache().factors)
        .close_drift(rig.state.motion);
    rig.begin();
    const double energy = rig.energy();
    const double momentum = rig.angular_momentum();
    for (int tick = 0; tick < 600; ++tick) {
        REQUIRE(rig.run(kTestTick));
        REQUIRE(gap_of(rig) < 1e-10);
    }
    CHECK(rig.energy() == Approx(energy).epsilon(1e-4));
    CHECK(rig.angular_momentum() == Approx(momentum).epsilon(1e-4));
}

// A third bar connects rods 0 and 2, parallel to rods 1 and 3, which makes half of its joint's
// constraints redundant. With two joints, all of the second one's are redundant.
TEST_CASE("redundant loop joints do no harm", "[dynamics][loops]") {
    BodyPlan once = rhombus(0.6);
    const Vec3 aside(0.15, 0.0, 0.0);
    attach(once, 0, aside, 1.2, kRotaryJoint, kHalfLength, kHalfWidth);
    once.parts[4].limit_low = -kFree;
    once.parts[4].limit_high = kFree;
    once.loop_joints.push_back({4, 2, kDistal, -aside});
    BodyPlan twice = once;
    for (const PlannedLoopJoint& joint : once.loop_joints)
        twice.loop_joints.push_back(joint);
    const auto end_of = [](const BodyPlan& plan) {
        Rig rig(plan, airless(9.81), kReference);
        flap(rig, 1.0);
        rig.state.motion.speed[4] = 1.0;
        for (int i = 0; i < 5; ++i)
            rig.state.motion.speed[i] += 0.3;
        rig.begin();
        for (int tick = 0; tick < 40; ++tick) {
            REQUIRE(rig.run(kTestTick));
            CHECK(gap_of(rig) < 1e-12);
            for (int i = 0; i < 5; ++i)
                CHECK(rig.state.motion.speed[i] ==
                      Approx(i == 0 || i == 2 ? -0.7 : 1.3).epsilon(1e-6));
        }
        return rig.state.motion;
    };
    const Motion expected = end_of(once);
    const Motion motion = end_of(twice);
    for (int c = 0; c < 7; ++c) {
        CHECK(motion.position[c] == Approx(expected.position[c]).margin(1e-9));
        CHECK(motion.speed[c] == Approx(expected.speed[c]).margin(1e-9));
    }
}

TEST_CASE("a loop falls freely", "[dynamics][loops]") {
    SceneSettings settings;
    settings.integrator = kReference;
    BodyPlan plan = ring(regular_turns(5));
    for (std::size_t i = 1; i < plan.parts.size(); ++i)
        plan.parts[i].max_effort = 0.2;
    const auto scene = make_scene(plan, airless(9.81), settings);
    const Vec3 start = scene->center_of_mass();
    for (int tick = 0; tick < 60; ++tick) {
        flail(*scene, plan, 1.0);
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        const Vec3 tip = transform(scene->part_pose(4), kDistal);
        CHECK((tip - transform(scene->part_pose(0), -kDistal)).norm() < 1e-10);
    }
    CHECK(scene->center_of_mass().x() == Approx(start.x()).margin(1e-9));
    CHECK(scene->center_of_mass().y() == Approx(start.y() - 0.5 * 9.81).epsilon(1e-9));
    CHECK(scene->audit().gross_motor_work > 0.01);
    CHECK(std::fabs(scene->audit().energy_residual) < 1e-3 * scene->audit().gross_motor_work);
}

TEST_CASE("one joint limit stops all of the loop", "[dynamics][loops]") {
    Rig rig(rhombus(0.6, 0.4), empty_space(), kReference);
    flap(rig, 0.5);
    rig.begin();
    const double energy = rig.energy();
    REQUIRE(rig.run(1.0));
    CHECK(rig.state.motion.position[1] == Approx(0.8).margin(1e-3));
    CHECK(rig.speed() < 1e-4);
    CHECK(rig.state.audit.limit_work + rig.state.audit.impulse_work ==
          Approx(-energy).epsilon(1e-3));
    CHECK(std::fabs(rig.state.audit.energy_residual) < 1e-3 * energy);
}

// With friction, impacts and rest, a loop joint acts in the same way as the joint of a tree.
TEST_CASE("a loop joint between two trees acts as one of a tree", "[dynamics][loops]") {
    SceneSettings settings;
    settings.integrator = kReference;
    BodyPlan jointed = rods({1.0}, -0.2, kFree, 0.8);
    BodyPlan closed = jointed;
    closed.parts[1].parent = -1;
    closed.loop_joints = {{0, 1, kDistal, -kDistal}};
    const auto one = make_scene(jointed, {}, settings);
    const auto two = make_scene(closed, {}, settings);
    for (int tick = 0; tick < 240; ++tick) {
        REQUIRE(run(*one, kTestTick));
        REQUIRE(run(*two, kTestTick));
        for (std::size_t i = 0; i < 2; ++i)
            CHECK((one->part_pose(i).position - two->part_pose(i).position).norm() < 1e-5);
    }
    CHECK(one->audit().events >= 2);
    CHECK(two->audit().impulse_work == Approx(one->audit().impulse_work).epsilon(1e-4));
    CHECK(two->audit().energy_residual == Approx(one->audit().energy_residual).margin(1e-4));
}

// Three rods of a closed loop cannot move relative to each other. The test has no friction, since
// its softness depends on the body touched.
TEST_CASE("a triangle closed by a loop joint bounces like a welded one", "[dynamics][loops]") {
    const double turn = 2.0 * kPi / 3.0;
    Environment environment;
    environment.elasticity = 0.5;
    environment.friction = 0.0;
    SceneSettings settings;
    settings.integrator = kReference;
    const auto closed = make_scene(ring({turn, turn}, 0.2, kFree, 0.6), environment, settings);
    const auto welded =
        make_scene(rods({turn, turn}, 0.2, kFree, 0.6, kRigidJoint), environment, settings);
    for (int tick = 0; tick < 60; ++tick) {
        REQUIRE(run(*closed, kTestTick));
        REQUIRE(run(*welded, kTestTick));
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK((closed->part_pose(i).position - welded->part_pose(i).position).norm() < 1e-4);
            CHECK((closed->part_twist(i).linear - welded->part_twist(i).linear).norm() < 1e-4);
        }
    }
    CHECK(closed->audit().events >= 2);
    REQUIRE(run(*closed, 4.0));
    CHECK(closed->part_pose(0).position.y() == Approx(kHalfWidth).margin(1e-3));
    CHECK(closed->kinetic_energy() < 1e-8);
}

TEST_CASE("a ring drops on the ground and comes to rest", "[dynamics][loops]") {
    SceneSettings settings;
    settings.integrator = kReference;
    const auto scene = make_scene(ring(regular_turns(6), 0.1, 0.6, 0.5), {}, settings);
    const double start = scene->energy();
    for (int tick = 0; tick < 600; ++tick) {
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        const Vec3 tip = transform(scene->part_pose(5), kDistal);
        REQUIRE((tip - transform(scene->part_pose(0), -kDistal)).norm() < 1e-4);
    }
    const SceneAudit& audit = scene->audit();
    CHECK(scene->kinetic_energy() < 1e-6 * start);
    CHECK(audit.max_penetration < 0.01);
    CHECK(audit.max_limit_overrun < 0.05);
    CHECK(std::fabs(audit.energy_residual) < 1e-2 * start);
    CHECK(audit.positive_work < 1e-2 * start);
}

TEST_CASE("parts that a loop joint connects never collide", "[dynamics][loops]") {
    BodyPlan plan = rhombus(0.6);
    const std::size_t across = build_planar_model(plan, 1.0)->colliding_pairs.size();
    CHECK(across == 2);  // pairs of rods 0 and 2, 1 and 3
    const Vec3 middle = transform(plan.parts[2].rest_pose, Vec3::Zero());
    const Vec3 in_first = plan.parts[0].rest_pose.orientation.conjugate() *
                          (middle - plan.parts[0].rest_pose.position);
    plan.loop_joints.push_back({0, 2, in_first, Vec3::Zero()});
    CHECK(build_planar_model(plan, 1.0)->colliding_pairs.size() == across - 1);
}

TEST_CASE("integrators that cannot hold loops refuse them", "[dynamics][loops]") {
    for (const IntegratorKind& kind : builtin_integrators().all()) {
        SceneSettings settings;
        settings.integrator = kind.id;
        const auto scene = planar_scene_kind().make(rhombus(0.6), {}, settings);
        INFO(kind.id);
        CHECK(static_cast<bool>(scene) == (kind.id == kReference));
        if (!scene) CHECK(scene.error().message.find("\"least-squares\"") != std::string::npos);
    }
}

TEST_CASE("loop joints that hold nothing are refused by number", "[dynamics][loops]") {
    CHECK(build_planar_model(rhombus(0.6), 1.0));
    CHECK(refused(closed_badly({0, 4, kDistal, kDistal}), "loop joint 1: there is no part 4"));
    CHECK(refused(closed_badly({-1, 0, kDistal, kDistal}), "loop joint 1: there is no part -1"));
    CHECK(refused(closed_badly({2, 2, kDistal, kDistal}), "loop joint 1: both its parts"));
    const Vec3 nowhere(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
    CHECK(refused(closed_badly({0, 2, nowhere, kDistal}), "loop joint 1: a number"));
    CHECK(refused(closed_badly({3, 0, kDistal, Vec3(2e-6 - kHalfLength, 0.0, 0.0)}),
                  "loop joint 1: its points are over"));
    CHECK(refused(closed_badly({3, 0, kDistal, Vec3(1e300, 1e300, 0.0)}),
                  "loop joint 1: its points are over"));
    BodyPlan welded = rhombus(0.6);
    welded.parts[1].motion = kRigidJoint;
    welded.loop_joints.push_back({0, 1, kDistal, -kDistal});
    CHECK(refused(welded, "loop joint 1: both its parts"));
    BodyPlan many = rhombus(0.6);
    many.loop_joints.resize(65, many.loop_joints[0]);
    CHECK(refused(many, "65 loop joints"));
}
