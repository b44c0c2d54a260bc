#include "planar/rig.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

// Returns a chain that never reaches a stop, with spins of 8 rad/s of both signs.
Rig spinning_chain(const std::string& integrator, double tolerance) {
    Rig rig(chain(6, 1e6), empty_space(), integrator, tolerance);
    rig.model.colliding_pairs.clear();
    for (int i = 0; i < 6; ++i)
        rig.state.motion.speed[i] = i % 2 == 0 ? 8.0 : -8.0 + i;
    rig.begin();
    return rig;
}

// The greatest drift of all ticks, since at a single tick a drift may pass through 0.
struct Drift {
    double energy = 0.0;
    double momentum = 0.0;
};

Drift drift_after_ten_seconds(const std::string& integrator, double tolerance) {
    Rig rig = spinning_chain(integrator, tolerance);
    const double energy = rig.energy();
    const double momentum = rig.angular_momentum();
    Drift drift;
    for (int tick = 0; tick < 600; ++tick) {
        REQUIRE(rig.run(kTestTick));
        drift.energy = std::fmax(drift.energy, std::fabs(rig.energy() / energy - 1.0));
        drift.momentum =
            std::fmax(drift.momentum, std::fabs(rig.angular_momentum() / momentum - 1.0));
    }
    return drift;
}

}  // namespace

TEST_CASE("a falling box follows the parabola", "[dynamics][free_motion]") {
    Environment environment;
    environment.has_ground = false;
    Rig rig(one_box(0.3, 0.1, 0.0, 0.0), environment);
    rig.state.motion.speed[center_of(rig.model, 0)] = 2.0;
    rig.begin();
    REQUIRE(rig.run(1.5));
    CHECK(rig.state.motion.position[center_of(rig.model, 0)] == Approx(3.0).epsilon(1e-12));
    CHECK(rig.state.motion.position[center_of(rig.model, 0) + 1] ==
          Approx(-0.5 * 9.81 * 2.25).epsilon(1e-12));
}

TEST_CASE("gravity pulls in its direction", "[dynamics][free_motion]") {
    Environment environment;
    environment.has_ground = false;
    environment.gravity = 4.0;
    environment.gravity_direction = 30.0;
    const auto scene = make_scene(one_box(0.3, 0.1, 0.0, 0.0), environment);
    REQUIRE(run(*scene, 1.0));
    CHECK(scene->center_of_mass().x() == Approx(2.0 * std::sqrt(0.75)).epsilon(1e-12));
    CHECK(scene->center_of_mass().y() == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("a free chain keeps its energy and angular momentum", "[dynamics][free_motion]") {
    const Drift drift = drift_after_ten_seconds("bogacki-shampine", 1e-3);
    CHECK(drift.energy < 5e-3);
    CHECK(drift.momentum < 1e-11);
}

TEST_CASE("a tenth of the tolerance is a fifth of the drift", "[dynamics][free_motion]") {
    for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
        const Drift coarse = drift_after_ten_seconds("bogacki-shampine", tolerance);
        const Drift fine = drift_after_ten_seconds("bogacki-shampine", 0.1 * tolerance);
        CHECK(fine.energy <= coarse.energy / 5);
    }
}

TEST_CASE("Dormand-Prince keeps energy closer still", "[dynamics][free_motion]") {
    const Drift coarse = drift_after_ten_seconds("dormand-prince", 1e-4);
    const Drift fine = drift_after_ten_seconds("dormand-prince", 1e-6);
    CHECK(coarse.energy < 1e-4);
    CHECK(fine.energy < 1e-5);
    CHECK(fine.energy <= coarse.energy / 8);
}

TEST_CASE("muscles cannot move the centre of mass in empty space", "[dynamics][free_motion]") {
    RandomStream random(stream_seed({1, 2}));
    const BodyPlan plan = random_tree(random, 9, 0.3, 100.0, 0.0);
    const auto scene = make_scene(plan, empty_space());
    const Vec3 start = scene->center_of_mass();
    for (int tick = 0; tick < 600; ++tick) {
        flail(*scene, plan, 3.0);
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
    }
    CHECK((scene->center_of_mass() - start).norm() < 1e-10);
    CHECK(scene->audit().gross_motor_work > 1.0);
}

TEST_CASE("joints stay together in violent motion", "[dynamics][free_motion]") {
    RandomStream random(stream_seed({3, 4}));
    const BodyPlan plan = random_tree(random, 12, 0.0, 100.0, 0.0);
    const auto scene = make_scene(plan, empty_space());
    double widest = 0.0;
    for (int tick = 0; tick < 600; ++tick) {
        flail(*scene, plan, 6.0);
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        for (std::size_t i = 1; i < plan.parts.size(); ++i) {
            const PlannedPart& part = plan.parts[i];
            const auto parent = static_cast<std::size_t>(part.parent);
            const Vec3 gap = transform(scene->part_pose(i), part.anchor_in_child) -
                             transform(scene->part_pose(parent), part.anchor_in_parent);
            widest = std::fmax(widest, gap.norm());
        }
    }
    CHECK(widest < 1e-12);
}

TEST_CASE("a free body's energy changes by its motors' work alone", "[dynamics][free_motion]") {
    RandomStream random(stream_seed({5, 6}));
    const BodyPlan plan = random_tree(random, 7, 0.3, 25.0, 0.0);
    SceneSettings settings;
    settings.tolerance = 1e-5;
    const auto scene = make_scene(plan, empty_space(), settings);
    for (int tick = 0; tick < 300; ++tick) {
        flail(*scene, plan, 2.0);
        REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
    }
    CHECK(std::fabs(scene->audit().energy_residual) < 1e-3 * scene->audit().gross_motor_work);
}
