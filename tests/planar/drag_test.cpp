#include "planar/forces/drag.h"

#include "planar/random_motion.h"
#include "planar/rig.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

Environment water(double linear, double quadratic, double gravity) {
    Environment environment;
    environment.has_ground = false;
    environment.gravity = gravity;
    environment.viscosity_linear = linear;
    environment.viscosity_quadratic = quadratic;
    return environment;
}

}  // namespace

TEST_CASE("a plate sinks at its terminal velocity", "[dynamics][drag]") {
    const double half_length = 0.4;
    const auto scene = make_scene(one_box(half_length, 0.02, 0.0, 0.0), water(0.0, 5.0, 9.81));
    REQUIRE(run(*scene, 10.0));
    const double terminal = std::sqrt(scene->mass() * 9.81 / (5.0 * 2 * half_length));
    CHECK(-scene->center_of_mass_velocity().y() == Approx(terminal).epsilon(1e-5));
}

TEST_CASE("linear drag slows a glide exponentially", "[dynamics][drag]") {
    Rig rig(one_box(0.3, 0.1, 0.0, 0.0), water(0.5, 0.0, 0.0), "bogacki-shampine", 1e-6);
    rig.state.motion.speed[center_of(rig.model, 0)] = 2.0;  // end-on: the short faces resist
    rig.begin();
    REQUIRE(rig.run(1.0));
    const double rate = 0.5 * 0.2 / rig.model.total_mass;
    CHECK(rig.state.motion.speed[center_of(rig.model, 0)] ==
          Approx(2.0 * exponential(-rate)).epsilon(1e-6));
    CHECK(rig.state.audit.drag_work ==
          Approx(rig.energy() - 0.5 * rig.model.total_mass * 4.0).epsilon(1e-5));
}

TEST_CASE("linear drag slows a spin exponentially", "[dynamics][drag]") {
    Rig rig(one_box(0.3, 0.1, 0.0, 0.0), water(0.5, 0.0, 0.0), "bogacki-shampine", 1e-6);
    rig.state.motion.speed[0] = 3.0;
    rig.begin();
    REQUIRE(rig.run(1.0));
    const double moment = 0.5 * (2.0 / 3.0) * (0.3 * 0.3 * 0.3 + 0.1 * 0.1 * 0.1);
    const double expected = 3.0 * exponential(-moment / rig.model.inertia[0]);
    CHECK(rig.state.motion.speed[0] == Approx(expected).epsilon(1e-6));
}

TEST_CASE("drag never does positive work", "[dynamics][drag]") {
    RandomStream random(stream_seed({8, 8}));
    const PlanarModel model = *build_planar_model(random_tree(random, 8, 0.3, 1.0, 0.0), 1.0);
    const Medium medium{0.0, 0.0, 0.5, 5.0};
    for (int i = 0; i < 1000; ++i) {
        Motion motion = rest_motion(model);
        for (int c = 0; c < coordinate_count(model); ++c) {
            motion.position[c] += random.gauss();
            motion.speed[c] = 5.0 * random.gauss();
        }
        Kinematics kinematics;
        compute_kinematics(model, motion, kinematics);
        Loads loads;
        clear_loads(model, loads);
        const double power = add_drag(model, medium, kinematics, loads);
        double done = 0.0;
        for (int b = 0; b < model.body_count; ++b)
            done += loads.force_x[b] * kinematics.velocity_x[b] +
                    loads.force_y[b] * kinematics.velocity_y[b] +
                    loads.torque[b] * kinematics.spin[b];
        CHECK(power <= 0.0);
        CHECK(done == Approx(power).epsilon(1e-9));
    }
}

// A model with one more box, which has no size, has no body for each of its boxes.
TEST_CASE("drag is the same to the last bit if each body is taken to be one box or not",
          "[dynamics][drag]") {
    RandomStream random(stream_seed({8, 9}));
    const Medium medium{0.0, 0.0, 0.5, 5.0};
    for (int i = 0; i < 200; ++i) {
        const int bodies = 1 + i % 30;
        const PlanarModel single =
            *build_planar_model(random_tree(random, bodies, 0.3, 1.0, 0.0), 1.0);
        REQUIRE(has_single_boxes(single));
        PlanarModel welded = single;
        ++welded.part_count;
        REQUIRE_FALSE(has_single_boxes(welded));
        Kinematics kinematics;
        compute_kinematics(single, random_motion(random, single), kinematics);
        Loads loads[2];
        double power[2];
        for (int which = 0; which < 2; ++which) {
            const PlanarModel& model = which == 0 ? single : welded;
            clear_loads(model, loads[which]);
            power[which] = add_drag(model, medium, kinematics, loads[which]);
        }
        REQUIRE(power[0] < 0.0);
        REQUIRE(power[0] == power[1]);
        for (int b = 0; b < bodies; ++b) {
            REQUIRE(loads[0].force_x[b] == loads[1].force_x[b]);
            REQUIRE(loads[0].force_y[b] == loads[1].force_y[b]);
            REQUIRE(loads[0].torque[b] == loads[1].torque[b]);
        }
    }
}
