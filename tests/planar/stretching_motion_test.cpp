#include "math/elementary.h"
#include "planar/model/stretching.h"
#include "planar/rig.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

double angular_momentum(const Rig& rig) {
    const Kinematics& k = rig.state.cache().kinematics;
    double sum = 0.0;
    for (int i = 0; i < rig.model.body_count; ++i) {
        if (rig.model.motion[i] == JointMotion::kStretch) continue;
        const InertiaParts parts = inertia_parts(rig.model, k, i);
        sum += (parts.length + parts.width) * k.spin[i] +
               rig.model.mass[i] * (k.x[i] * k.velocity_y[i] - k.y[i] * k.velocity_x[i]);
    }
    return sum;
}

struct Books {
    double residual = 0.0;  // J
    double gross = 0.0;     // J
    double momentum = 0.0;  // relative drift of the angular momentum
    double drift = 0.0;     // m/s, of the centre of mass
    double steps = 0.0;     // of the integrator
};

constexpr int kTicks = 600;

// Two parts, both deforming by +-0.4 at 1 Hz and the joint between them by +-0.6 rad, for 10 s.
Books move_freely(double tolerance) {
    BodyPlan plan = one_box(0.2, 0.05, 0.0, 0.0);
    attach(plan, 0, Vec3(0.2, 0.0, 0.0), 0.0, kRotaryJoint).max_effort = 0.25;
    for (PlannedPart& part : plan.parts)
        make_deformable(part, -0.5, 0.5);
    Rig rig(plan, empty_space(), "dormand-prince", tolerance);
    const int joint = 2;
    rig.state.motion.speed[0] = 2.0;
    rig.state.motion.speed[joint] = 2.0;
    rig.state.motion.speed[center_of(rig.model, 0)] = 0.3;
    rig.begin();
    const double momentum = angular_momentum(rig);
    for (int tick = 0; tick < kTicks; ++tick) {
        const auto wave = [&](double amplitude, double phase, int slot) {
            rig.forcing.drive.start[slot] = amplitude * sine(2.0 * kPi * tick * kTestTick + phase);
            rig.forcing.drive.end[slot] =
                amplitude * sine(2.0 * kPi * (tick + 1) * kTestTick + phase);
        };
        wave(0.4, 0.0, 1);
        wave(0.4, 1.0, 3);
        wave(0.6, 2.0, joint);
        REQUIRE(rig.run(kTestTick));
    }
    const SceneAudit& audit = rig.state.audit;
    return {std::fabs(audit.energy_residual), audit.gross_motor_work,
            std::fabs(angular_momentum(rig) / momentum - 1.0),
            std::fabs(rig.state.motion.speed[center_of(rig.model, 0)] - 0.3),
            static_cast<double>(audit.steps)};
}

}  // namespace

TEST_CASE("free deforming creatures keep their energy balance and their momentum",
          "[dynamics][stretching]") {
    const Books coarse = move_freely(1e-3);
    const Books middle = move_freely(1e-5);
    CAPTURE(coarse.residual, middle.residual, coarse.gross, coarse.momentum, middle.momentum);
    CHECK(coarse.residual <= 1e-3 * coarse.gross);
    CHECK(middle.residual <= 1e-4 * middle.gross);
    CHECK(middle.momentum <= 1e-4);
    CHECK(coarse.drift == 0.0);
    CHECK(coarse.gross > 0.1);
}

// With a coarser tolerance most steps are as long as a tick, the longest that is allowed, so the
// tolerance hardly matters.
TEST_CASE("a tenth of the tolerance leaves less than an eighth of a deforming creature's error",
          "[dynamics][stretching]") {
    Books before = move_freely(1e-5);
    CHECK(before.steps > 1.4 * kTicks);
    for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-9}) {
        const Books now = move_freely(tolerance);
        CAPTURE(tolerance, before.residual, now.residual, now.steps);
        CHECK(now.residual <= before.residual / 8.0);
        before = now;
    }
}

TEST_CASE("a spinning part that lengthens slows down", "[dynamics][stretching]") {
    BodyPlan plan = one_box(0.3, 0.08, 0.0, 0.0);
    make_deformable(plan.parts[0], -0.5, 0.5);
    Rig rig(plan, empty_space(), "dormand-prince", 1e-7);
    rig.state.motion.speed[0] = 6.0;
    rig.begin();
    const InertiaParts before = inertia_parts(rig.model, rig.state.cache().kinematics, 0);
    const double energy = rig.energy();
    for (int tick = 0; tick < 360; ++tick) {
        rig.forcing.drive.start[1] = rig.forcing.drive.end[1];
        rig.forcing.drive.end[1] = 0.405;
        REQUIRE(rig.run(kTestTick));
    }
    const InertiaParts after = inertia_parts(rig.model, rig.state.cache().kinematics, 0);
    const double ratio = (before.length + before.width) / (after.length + after.width);
    CHECK(rig.state.motion.position[1] > 0.38);
    CHECK(rig.state.motion.speed[0] == Approx(6.0 * ratio).epsilon(1e-5));
    const double work = rig.state.audit.motor_work;
    CHECK(std::fabs(rig.energy() - energy - work) <= 1e-5 * std::fabs(work));
    CHECK(rig.energy() < energy);
}

TEST_CASE("a stretch stops at its limits", "[dynamics][stretching]") {
    BodyPlan plan = one_box(0.3, 0.08, 0.0, 0.0);
    make_deformable(plan.parts[0], -0.2, 0.3);
    Rig rig(plan, empty_space());
    rig.begin();
    rig.forcing.drive.frequency = 0.0;
    rig.state.motion.speed[0] = 12.0;
    rig.state.motion.speed[1] = 1.0;
    rig.state.cache_is_current = false;
    for (int tick = 0; tick < 300; ++tick) {
        REQUIRE(rig.run(kTestTick));
        CHECK(rig.state.motion.position[1] < 0.3 + 0.03);
    }
    CHECK(rig.state.motion.position[1] == Approx(0.3).margin(2e-3));
}

TEST_CASE("a part keeps its area while it deforms", "[dynamics][stretching]") {
    BodyPlan plan = one_box(0.3, 0.08, 0.0, 0.0);
    make_deformable(plan.parts[0], -0.5, 0.5);
    const auto scene = make_scene(plan, empty_space());
    scene->set_stretch_target(0, 0.4);
    REQUIRE(run(*scene, 2.0));
    const Vec3 half = scene->part_half_extents(0);
    CHECK(scene->stretch(0) == Approx(0.4).margin(5e-3));
    CHECK(half.x() > 0.43);
    CHECK(half.x() * half.y() == Approx(0.3 * 0.08).epsilon(1e-14));
    CHECK(scene->bounds().high.x() - scene->bounds().low.x() == Approx(2.0 * half.x()));
}

TEST_CASE("a plan with limits of a stretch of the wrong sign is refused",
          "[dynamics][stretching]") {
    BodyPlan plan = one_box(0.3, 0.08, 0.0, 0.0);
    plan.parts[0].stretch = PlannedStretch{0.1, 0.3, 1.0, 1.5};
    const auto model = build_planar_model(plan, 1.0);
    REQUIRE_FALSE(model);
    CHECK(model.error().message ==
          "body plan, part 0: limits of its stretch exclude its rest shape");
}

TEST_CASE("the reference integrator refuses deformable parts", "[dynamics][stretching]") {
    BodyPlan plan = one_box(0.3, 0.08, 0.0, 0.0);
    make_deformable(plan.parts[0], -0.5, 0.5);
    SceneSettings settings;
    settings.integrator = "least-squares";
    const auto scene = planar_scene_kind().make(plan, empty_space(), settings);
    REQUIRE_FALSE(scene);
    CHECK(scene.error().message.find("deformable parts need another integrator") !=
          std::string::npos);
}
