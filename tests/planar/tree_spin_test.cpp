// A body that nothing touches keeps its angular momentum, whatever it does.

#include "planar/evaluation/accelerations.h"
#include "planar/random_motion.h"
#include "planar/rig.h"
#include "planar/stepping/tree_spins.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

// Returns one of many creatures: some with linear joints, some with a deformable part.
BodyPlan creature(std::uint64_t seed, double height = 0.0) {
    RandomStream random(stream_seed({seed, 71}));
    const int parts = 3 + static_cast<int>(seed % 10);
    BodyPlan plan = random_tree(random, parts, seed % 4 == 3 ? 0.3 : 0.0, 40.0, height);
    if (seed % 5 == 4) make_deformable(plan.parts[1], -0.25, 0.25);
    return plan;
}

double root_angle(const PhysicsScene& scene) {
    const Vec3 axis = scene.part_axis(0);
    return std::atan2(axis.y(), axis.x());
}

// How far a creature has turned after 10 s, and how much angular momentum it had on the way.
struct Turn {
    double angle = 0.0;        // rad
    double worst_share = 0.0;  // of the parts' momentum
    SceneAudit audit;
};

Turn flail_freely(std::uint64_t seed, const Environment& environment,
                  const SceneSettings& settings = {}) {
    const BodyPlan plan = creature(seed);
    const auto scene = make_scene(plan, environment, settings);
    Turn turn;
    double angular = 0.0;
    double gross = 0.0;
    for (int tick = 0; tick < 600; ++tick) {
        flail(*scene, plan, 2.0);
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        const AngularMomentum momentum = angular_momentum_of(*scene, environment.density);
        angular = std::fmax(angular, std::fabs(momentum.sum));
        gross = std::fmax(gross, momentum.gross);
    }
    turn.angle = root_angle(*scene);
    turn.worst_share = angular / gross;
    turn.audit = scene->audit();
    return turn;
}

SceneSettings fine_settings() {
    SceneSettings settings;
    settings.integrator = "dormand-prince";
    settings.tolerance = 1e-7;
    return settings;
}

double angle_between(double first, double second) {
    return std::fabs(std::remainder(first - second, 2.0 * kPi));
}

}  // namespace

TEST_CASE("a creature cannot set itself spinning in empty space", "[dynamics][tree_spin]") {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        CAPTURE(seed);
        const Turn turn = flail_freely(seed, empty_space());
        CHECK(turn.worst_share < 1e-9);
        CHECK(turn.audit.spin_scale > 0.0);
        CHECK(turn.audit.spin_gained < 1e-9 * turn.audit.spin_scale);
    }
}

TEST_CASE("a creature turns as it does when computed more finely", "[dynamics][tree_spin]") {
    for (const std::uint64_t seed : {3U, 7U, 12U}) {
        CAPTURE(seed);
        const double angle = flail_freely(seed, empty_space()).angle;
        CHECK(angle_between(angle, flail_freely(seed, empty_space(), fine_settings()).angle) <
              5e-3);
    }
}

TEST_CASE("every integrator keeps the angular momentum", "[dynamics][tree_spin]") {
    for (const std::string& integrator : integrator_ids()) {
        CAPTURE(integrator);
        SceneSettings settings;
        settings.integrator = integrator;
        CHECK(flail_freely(1, empty_space(), settings).worst_share < 1e-9);
    }
}

TEST_CASE("a creature keeps its spin from one impact to the next", "[dynamics][tree_spin]") {
    const BodyPlan plan = creature(2, 1.0);
    Environment environment;
    environment.elasticity = 0.8;
    const auto scene = make_scene(plan, environment);
    scene->translate(Vec3(0.0, 0.5 - scene->lowest_point(), 0.0));
    double before = 0.0;
    int free_ticks = 0;
    std::uint64_t impacts = 0;
    double greatest = 0.0;
    double greatest_change = 0.0;
    for (int tick = 0; tick < 300; ++tick) {
        flail(*scene, plan, 2.0);
        const bool was_free = scene->lowest_point() > 0.03;
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        const AngularMomentum momentum = angular_momentum_of(*scene, environment.density);
        greatest = std::fmax(greatest, std::fabs(momentum.sum));
        if (was_free && scene->lowest_point() > 0.03 && scene->audit().events == impacts) {
            ++free_ticks;
            greatest_change = std::fmax(greatest_change, std::fabs(momentum.sum - before));
        }
        before = momentum.sum;
        impacts = scene->audit().events;
    }
    CHECK(impacts > 0);
    CHECK(free_ticks > 10);
    CHECK(greatest > 1e-3);
    CHECK(greatest_change < 1e-10 * greatest);
}

TEST_CASE("packing and saving keep what the spin must be", "[dynamics][tree_spin]") {
    for (const Environment& environment : {empty_space(), open_water()}) {
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            CAPTURE(seed);
            const BodyPlan plan = creature(seed);
            const auto kept = make_scene(plan, environment);
            const auto packed = make_scene(plan, environment);
            auto saved = make_scene(plan, environment);
            for (int tick = 0; tick < 90; ++tick) {
                packed->give_workspace(packed->take_workspace());
                if (tick % 20 == 19) {
                    auto copy = make_scene(plan, environment);
                    copy->restore(*saved->save());
                    saved = std::move(copy);
                }
                for (PhysicsScene* scene : {kept.get(), packed.get(), saved.get()}) {
                    flail(*scene, plan, 2.0);
                    REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
                }
            }
            CHECK(kept->motion().speeds == packed->motion().speeds);
            CHECK(kept->motion().speeds == saved->motion().speeds);
        }
    }
}

TEST_CASE("drag gives the angular momentum that its accelerations show", "[dynamics][tree_spin]") {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        RandomStream random(stream_seed({seed, 72}));
        const Rig rig(creature(seed), open_water());
        const Motion motion = random_motion(random, rig.model);
        EvaluationCache cache = {};
        MotionRate rate = {};
        evaluate_accelerations(rig.model, rig.forcing, motion, {}, cache, rate);
        // The derivative of the momentum along the motion, by central differences.
        const double step = 1e-5;
        double momenta[2];
        for (int side = 0; side < 2; ++side) {
            const double time = side == 0 ? -step : step;
            Motion moved = motion;
            for (int c = 0; c < coordinate_count(rig.model); ++c) {
                moved.position[c] += time * (motion.speed[c] + 0.5 * time * rate.acceleration[c]);
                moved.speed[c] += time * rate.acceleration[c];
            }
            Kinematics kinematics = {};
            compute_kinematics(rig.model, moved, kinematics);
            momenta[side] = spin_of_tree(rig.model, moved, kinematics, 0).momentum;
        }
        const double derivative = (momenta[1] - momenta[0]) / (2.0 * step);
        CHECK(rate.power[kSpinGiven] == Approx(derivative).epsilon(1e-6).margin(1e-6));
    }
}

TEST_CASE("in water a creature moves as it does when computed more finely",
          "[dynamics][tree_spin]") {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        CAPTURE(seed);
        const double angle = flail_freely(seed, open_water()).angle;
        CHECK(angle_between(angle, flail_freely(seed, open_water(), fine_settings()).angle) < 3e-3);
    }
}

TEST_CASE("a pull beside the centre gives its moment", "[dynamics][tree_spin]") {
    // A free box under a couple that turns with it: angular acceleration is moment / inertia.
    const auto scene = make_scene(one_box(0.3, 0.1, 0.0, 0.0), empty_space());
    const double inertia = scene->mass() * (0.3 * 0.3 + 0.1 * 0.1) / 3.0;
    double given = 0.0;
    for (int tick = 0; tick < 60; ++tick) {
        const double angle_before = root_angle(*scene);
        scene->pull(0, Vec3(0.3, 0.0, 0.0), Vec3(0.0, 0.1, 0.0));
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        // Simpson's rule over the lever of the tick.
        const double angle_after = root_angle(*scene);
        const double middle = 0.5 * (angle_before + angle_after);
        given += kTestTick / 6.0 * 0.1 * 0.3 *
                 (std::cos(angle_before) + 4.0 * std::cos(middle) + std::cos(angle_after));
    }
    CHECK(scene->part_twist(0).angular.z() * inertia == Approx(given).epsilon(1e-4));
}

TEST_CASE("restoring the spin of a tree adds spin alone", "[dynamics][tree_spin]") {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        RandomStream random(stream_seed({seed, 73}));
        const Rig rig(creature(seed), empty_space());
        Motion motion = random_motion(random, rig.model);
        Kinematics turned = {};
        compute_kinematics(rig.model, motion, turned);
        const Kinematics before = turned;
        const TreeSpin spin = spin_of_tree(rig.model, motion, turned, 0);
        const double kinetic =
            restore_spin(rig.model, 0, spin.momentum, 0.7 * spin.inertia, motion, turned);
        CHECK(spin_of_tree(rig.model, motion, turned, 0).momentum ==
              Approx(spin.momentum + 0.7 * spin.inertia));
        CHECK(kinetic == kinetic_energy(rig.model, turned));
        Kinematics again = {};
        compute_kinematics(rig.model, motion, again);
        for (int i = 0; i < rig.model.body_count; ++i) {
            CHECK(again.velocity_x[i] == Approx(turned.velocity_x[i]).margin(1e-12));
            CHECK(again.velocity_y[i] == Approx(turned.velocity_y[i]).margin(1e-12));
            CHECK(again.spin[i] == Approx(turned.spin[i]).margin(1e-12));
            CHECK(again.joint_rate[i] == Approx(before.joint_rate[i]).margin(1e-12));
        }
    }
}
