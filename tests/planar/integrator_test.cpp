#include "planar/rig.h"
#include "planar/stepping/time_of_impact.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

// Returns the start of a bar that swings in drag. Its motion is smooth but not a polynomial.
Motion start_of(const PlanarModel& model) {
    Motion motion = rest_motion(model);
    for (int c = 0; c < coordinate_count(model); ++c)
        motion.speed[c] = 3.0 + 0.5 * c;
    return motion;
}

// Returns the largest error of a coordinate after 0.1 s in equal steps, against very small ones.
double error_of(const IntegratorKind& kind, int steps) {
    const PlanarModel model = *build_planar_model(chain(3, 1e6), 1.0);
    Forcing forcing;
    forcing.medium = {0.0, -9.81, 0.5, 0.0};
    const MotionSystem system{model, forcing, 0.1};
    const auto final_state = [&](const IntegratorKind& method, int count) {
        EvaluationCache cache = {};
        MotionRate rate = {};
        StepResult result;
        Motion motion = start_of(model);
        system.evaluate(motion, 0.0, EvaluationDetail::kEverything, cache, rate);
        for (int i = 0; i < count; ++i) {
            const double h = 0.1 / count;
            method.attempt(system, {motion, rate, i * h, h, 1e-3}, cache, result);
            motion = result.end;
            rate = result.end_rate;
        }
        return motion;
    };
    const Motion exact = final_state(*builtin_integrators().find("dormand-prince"), 400);
    const Motion motion = final_state(kind, steps);
    double error = 0.0;
    for (int c = 0; c < coordinate_count(model); ++c)
        error = std::fmax(error, std::fabs(motion.position[c] - exact.position[c]));
    return error;
}

double order_of(const std::string& id, int steps) {
    const IntegratorKind& kind = *builtin_integrators().find(id);
    return std::log2(error_of(kind, steps) / error_of(kind, 2 * steps));
}

}  // namespace

TEST_CASE("integrators converge with their order", "[dynamics][integrator]") {
    CHECK(order_of("bogacki-shampine", 16) == Approx(3.0).margin(0.4));
    CHECK(order_of("dormand-prince", 8) == Approx(5.0).margin(0.7));
    CHECK(order_of("cash-karp", 8) == Approx(5.0).margin(0.7));
    CHECK(order_of("semi-implicit", 64) == Approx(1.0).margin(0.2));
}

TEST_CASE("every integrator lets a box bounce and settle", "[dynamics][integrator]") {
    for (const IntegratorKind& kind : builtin_integrators().all()) {
        Environment environment;
        environment.elasticity = 0.5;
        SceneSettings settings;
        settings.integrator = kind.id;
        const auto scene = make_scene(one_box(0.2, 0.1, 0.0, 0.6, 0.3), environment, settings);
        INFO(kind.id);
        REQUIRE(run(*scene, 5.0));
        CHECK(scene->center_of_mass().y() == Approx(0.1).margin(2e-3));
        CHECK(scene->center_of_mass_velocity().norm() < 1e-4);
    }
}

TEST_CASE("every integrator moves a walker without runaway energy", "[dynamics][integrator]") {
    RandomStream random(stream_seed({41}));
    const BodyPlan plan = random_tree(random, 5, 0.2, 20.0, 1.2);
    for (const IntegratorKind& kind : builtin_integrators().all()) {
        SceneSettings settings;
        settings.integrator = kind.id;
        const auto scene = make_scene(plan, {}, settings);
        INFO(kind.id);
        for (int tick = 0; tick < 300; ++tick) {
            flail(*scene, plan, 1.0);
            REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        }
        const SceneAudit& audit = scene->audit();
        CHECK(std::fabs(audit.energy_residual) < 0.1 * audit.energy_scale);
    }
}

TEST_CASE("dense output meets the step's ends and an analytic parabola between",
          "[dynamics][integrator]") {
    const double h = 0.01;
    Motion start = {};
    Motion end = {};
    MotionRate rate = {};
    start.speed[0] = 1.0;
    rate.acceleration[0] = -4.0;
    end.position[0] = h * (1.0 - 2.0 * h);
    end.speed[0] = 1.0 - 4.0 * h;
    rate.power[kMotorWork] = 2.0;
    end.work[kMotorWork] = 2.0 * h;
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
        Motion motion;
        interpolate_motion(1, {start, rate, end, rate, h}, share, motion);
        const double t = share * h;
        CHECK(motion.position[0] == Approx(t - 2.0 * t * t).margin(1e-16));
        CHECK(motion.speed[0] == Approx(1.0 - 4.0 * t).margin(1e-15));
        CHECK(motion.work[kMotorWork] == Approx(2.0 * t).margin(1e-16));
    }
}
