// Deformable parts on the ground, against each other and in a medium.

#include "math/elementary.h"
#include "planar/bodies.h"
#include "planar/forces/drag.h"
#include "planar/model_building.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

// Five parts of 0.3 m x 0.12 m in a row, with rigid joints.
BodyPlan worm() {
    BodyPlan plan = one_box(0.15, 0.06, 0.0, 0.0);
    for (int part = 1; part < 5; ++part)
        attach(plan, part - 1, Vec3(0.15, 0.0, 0.0), 0.0, kRigidJoint, 0.15, 0.06);
    for (PlannedPart& part : plan.parts) {
        make_deformable(part, -0.5, 0.5);
        part.stretch->rate_limit = 3.0;
    }
    return plan;
}

// Returns how far the worm crawls in 10 s, in m, with waves of 0.35 at 1 Hz and this phase from
// part to part.
double crawl(double phase) {
    Environment ground;
    ground.friction = 0.8;
    const auto scene = make_scene(worm(), ground);
    stand_on_ground(*scene);
    const double start = scene->center_of_mass().x();
    for (int tick = 0; tick < 600; ++tick) {
        const double time = (tick + 1) * kTestTick;
        for (std::size_t part = 0; part < 5; ++part)
            scene->set_stretch_target(
                part, 0.35 * std::fmin(1.0, time) *
                          sine(2.0 * kPi * time - phase * static_cast<double>(part)));
        if (scene->advance(kTestTick) != SceneStatus::kRunning) return 0.0;
    }
    CHECK(std::fabs(scene->audit().energy_residual) < 0.02 * scene->audit().energy_scale);
    CHECK(scene->audit().max_penetration < 0.02);
    return scene->center_of_mass().x() - start;
}

}  // namespace

TEST_CASE("a worm crawls against the waves that run along it", "[dynamics][stretching]") {
    const double forward = crawl(2.0 * kPi / 5.0);
    const double backward = crawl(-2.0 * kPi / 5.0);
    const double in_step = crawl(0.0);
    CAPTURE(forward, backward, in_step);
    CHECK(std::fabs(forward) >= 2.0);
    CHECK(std::fabs(forward + backward) <= 0.05 * std::fabs(forward));
    CHECK(std::fabs(in_step) <= 0.2);
}

TEST_CASE("a creature whose stretches are held moves like a rigid one", "[dynamics][stretching]") {
    BodyPlan rigid = chain(4, 1.0);
    for (PlannedPart& part : rigid.parts)
        part.max_effort = 0.3;
    attach(rigid, 1, Vec3(0.0, 0.05, 0.0), 1.2, kRigidJoint, 0.1, 0.04);
    BodyPlan held = rigid;
    for (PlannedPart& part : held.parts)
        make_deformable(part, -1e-9, 1e-9);
    const auto first = make_scene(rigid, {});
    const auto second = make_scene(held, {});
    for (PhysicsScene* scene : {first.get(), second.get()})
        stand_on_ground(*scene);
    for (int tick = 0; tick < 300; ++tick) {
        for (std::size_t part = 1; part < 4; ++part) {
            const double target = 0.5 * sine(3.0 * tick * kTestTick + static_cast<double>(part));
            first->set_target(part, target);
            second->set_target(part, target);
        }
        REQUIRE(first->advance(kTestTick) == SceneStatus::kRunning);
        REQUIRE(second->advance(kTestTick) == SceneStatus::kRunning);
    }
    const Vec3 apart = first->center_of_mass() - second->center_of_mass();
    CAPTURE(first->center_of_mass().x(), second->center_of_mass().x());
    CHECK(apart.norm() < 1e-3);
}

TEST_CASE("a plate that shortens and lengthens in a medium only loses energy to it",
          "[dynamics][stretching]") {
    BodyPlan plan = one_box(0.4, 0.15, 0.0, 0.0);
    make_deformable(plan.parts[0], -0.5, 0.5);
    Environment medium = open_water();
    SceneSettings settings;
    settings.tolerance = 1e-4;
    const auto scene = make_scene(plan, medium, settings);
    double before = 0.0;
    for (int tick = 0; tick < 600; ++tick) {
        scene->set_stretch_target(0, 0.4 * sine(2.0 * kPi * tick * kTestTick));
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        const double work = scene->audit().drag_work;
        CHECK(work <= before);
        before = work;
    }
    CHECK(before < 0.0);
    CHECK(std::fabs(scene->audit().energy_residual) <= 1e-3 * scene->audit().gross_motor_work);
    CHECK(scene->center_of_mass().norm() < 1e-9);
}

TEST_CASE("drag on a deforming part has the power of its forces", "[dynamics][stretching]") {
    RandomStream random(stream_seed({241}));
    for (int round = 0; round < 100; ++round) {
        BodyPlan plan = one_box(0.4, 0.15, 0.0, 0.0);
        make_deformable(plan.parts[0], -0.5, 0.5);
        const PlanarModel model = *build_planar_model(plan, 1.0);
        Motion motion = rest_motion(model);
        for (int c = 0; c < coordinate_count(model); ++c) {
            motion.position[c] = 0.3 * random.gauss();
            motion.speed[c] = 2.0 * random.gauss();
        }
        Kinematics k;
        compute_kinematics(model, motion, k);
        Loads loads;
        clear_loads(model, loads);
        const double power = add_stretched_drag(model, {0.0, 0.0, 0.7, 1.3}, k, loads);
        const double given = loads.force_x[0] * k.velocity_x[0] +
                             loads.force_y[0] * k.velocity_y[0] + loads.torque[0] * k.spin[0] +
                             loads.effort[1] * k.stretch_rate[0];
        CHECK(power < 0.0);
        CHECK(given == Approx(power).epsilon(1e-12));
    }
}

TEST_CASE("drag on a part that keeps its shape is that on a rigid one", "[dynamics][stretching]") {
    RandomStream random(stream_seed({242}));
    for (int round = 0; round < 100; ++round) {
        BodyPlan plan = one_box(0.4, 0.15, 0.0, 0.0);
        const PlanarModel rigid = *build_planar_model(plan, 1.0);
        make_deformable(plan.parts[0], -0.5, 0.5);
        const PlanarModel held = *build_planar_model(plan, 1.0);
        Loads loads[2];
        double power[2];
        const double angle = random.gauss();
        const double speeds[3] = {random.gauss(), random.gauss(), random.gauss()};
        for (const PlanarModel* model : {&rigid, &held}) {
            const int which = model == &held ? 1 : 0;
            Motion motion = rest_motion(*model);
            motion.position[0] = angle;
            motion.speed[0] = speeds[0];
            motion.speed[center_of(*model, 0)] = speeds[1];
            motion.speed[center_of(*model, 0) + 1] = speeds[2];
            Kinematics k;
            compute_kinematics(*model, motion, k);
            clear_loads(*model, loads[which]);
            const Medium medium{0.0, 0.0, 0.7, 1.3};
            power[which] = which == 0 ? add_drag(*model, medium, k, loads[0])
                                      : add_stretched_drag(*model, medium, k, loads[1]);
        }
        CHECK(power[0] == Approx(power[1]).epsilon(1e-12));
        CHECK(loads[0].force_x[0] == Approx(loads[1].force_x[0]).margin(1e-12));
        CHECK(loads[0].force_y[0] == Approx(loads[1].force_y[0]).margin(1e-12));
        CHECK(loads[0].torque[0] == Approx(loads[1].torque[0]).margin(1e-12));
    }
}

TEST_CASE("a deforming part rests on the ground with its present width", "[dynamics][stretching]") {
    BodyPlan plan = one_box(0.3, 0.1, 0.0, 0.0);
    make_deformable(plan.parts[0], -0.5, 0.5);
    const auto scene = make_scene(plan, {});
    stand_on_ground(*scene);
    scene->set_stretch_target(0, -0.3);
    REQUIRE(run(*scene, 4.0));
    CHECK(scene->stretch(0) == Approx(-0.3).margin(0.1));
    CHECK(scene->center_of_mass().y() == Approx(scene->part_half_extents(0).y()).margin(2e-3));
    CHECK(scene->face_touched(0, Face::kRight));
    CHECK(scene->kinetic_energy() < 1e-6);
}

TEST_CASE("deforming creatures that flail keep finite motions without spurious energy",
          "[dynamics][stretching]") {
    RandomStream random(stream_seed({243}));
    int suspects = 0;
    constexpr int kCreatures = 60;
    for (int round = 0; round < kCreatures; ++round) {
        BodyPlan plan = random_tree(random, random.between(2, 10), 0.2, 2.0, 0.5);
        for (PlannedPart& part : plan.parts) {
            if (random.uniform() < 0.6) make_deformable(part, -0.5, 0.5);
            if (random.uniform() < 0.3) part.motion = kRigidJoint;
        }
        const auto scene = make_scene(plan, {});
        stand_on_ground(*scene);
        const double pace = random.uniform(0.5, 2.0);
        for (int tick = 0; tick < 180; ++tick) {
            for (std::size_t part = 0; part < plan.parts.size(); ++part) {
                const double wave =
                    sine(2.0 * kPi * pace * tick * kTestTick + static_cast<double>(part));
                scene->set_target(part, plan.parts[part].limit_high * wave);
                scene->set_stretch_target(part, 0.5 * wave);
            }
            REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        }
        CHECK(std::isfinite(scene->energy()));
        const SceneAudit& audit = scene->audit();
        if (std::fabs(audit.energy_residual) > 0.05 * audit.energy_scale) ++suspects;
    }
    CHECK(suspects <= kCreatures / 20);
}
