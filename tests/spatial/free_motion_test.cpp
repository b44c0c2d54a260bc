#include "spatial/bodies.h"
#include "spatial/steps.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace cambrian {
namespace {

using namespace spatial;

SceneSettings settings_of(const std::string& integrator, double tolerance = 4e-3) {
    SceneSettings settings;
    settings.integrator = integrator;
    settings.tolerance = tolerance;
    return settings;
}

// Starts a single box with this spin about its own axes.
void spin_box(PhysicsScene& scene, const Vec3& half, const Vec3& spin) {
    const Vec3 squares = half.cwiseProduct(half);
    const Vec3 momentum =
        scene.mass() / 3.0 *
        Vec3((squares.y() + squares.z()) * spin.x(), (squares.x() + squares.z()) * spin.y(),
             (squares.x() + squares.y()) * spin.z());
    SceneMotion motion = scene.motion();
    for (int i = 0; i < 3; ++i)
        motion.speeds[static_cast<std::size_t>(i)] = momentum[i];
    REQUIRE(scene.begin_at(motion));
}

// Energy, attitude and angular momentum of an asymmetric box after steps of one length.
struct Tumble {
    double energy_error = 0.0;    // relative
    double momentum_error = 0.0;  // relative, of the parts' sum
};

Tumble tumble(const Integrator& integrator, double step, double duration) {
    const Model model = *build_model(one_solid(Vec3(0.5, 0.3, 0.1)), 1000.0);
    Forcing forcing;
    Motion motion = rest_motion(model);
    Evaluation evaluation;
    MotionRate rate;
    evaluate(model, forcing, motion, 0.0, evaluation, rate);
    set_coordinate_vector(motion.speed,
                          evaluation.kinematics.whole_inertia * Vec3(0.01, 8.0, 0.01));
    evaluate(model, forcing, motion, 0.0, evaluation, rate);
    const double energy = kinetic_energy(model, motion, evaluation.kinematics);
    const Vec3 momentum = coordinate_vector(motion.speed);
    Tumble result;
    StepResult next;
    const int steps = static_cast<int>(std::lround(duration / step));
    for (int i = 0; i < steps; ++i) {
        const MotionSystem system{model, forcing, step};
        integrator.attempt(system, {motion, rate, 0.0, step, 1.0}, evaluation, next);
        motion = next.end;
        rate = next.end_rate;
        restart_chart(model, motion);
        set_coordinate_vector(rate.position, evaluation.kinematics.spin[0]);
        const double now = kinetic_energy(model, motion, evaluation.kinematics);
        result.energy_error = std::fmax(result.energy_error, std::fabs(now / energy - 1.0));
        const Vec3 sum = evaluation.kinematics.whole_inertia * evaluation.kinematics.spin[0];
        result.momentum_error =
            std::fmax(result.momentum_error, (sum - momentum).norm() / momentum.norm());
    }
    return result;
}

}  // namespace

// A2.
TEST_CASE("The axis of a symmetric top goes round its angular momentum") {
    const Vec3 half(0.3, 0.1, 0.1);
    const auto worst_angle = [&half](const char* integrator, double tolerance) {
        const auto scene =
            make_solid(one_solid(half), weightless(), settings_of(integrator, tolerance));
        spin_box(*scene, half, Vec3(6.0, 2.0, 0.0));
        const Vec3 momentum = angular_momentum(*scene, 1000.0);
        const double inertia = scene->mass() / 3.0 * (0.3 * 0.3 + 0.1 * 0.1);
        const double rate = momentum.norm() / inertia;
        CHECK(rate == Approx(2.3324).epsilon(1e-4));
        run_ticks(*scene, 600);
        const Vec3 direction = momentum.normalized();
        const Rotation turn = rotation_by(Vec3(10.0 * rate * direction));
        const Vec3 expected = turn * Vec3::UnitX();
        return (scene->part_axis(0) - expected).norm();
    };
    const double usual = worst_angle("bogacki-shampine", 4e-3);
    const double exact = worst_angle("dormand-prince", 1e-6);
    CAPTURE(usual, exact);
    CHECK(usual < 1e-3);
    CHECK(exact < 1e-6);
}

// A3.
TEST_CASE("A box that turns about its middle axis tumbles without losing energy") {
    const auto known = integrators();
    const Tumble coarse = tumble(known[0], 1.0 / 120, 20.0);
    const Tumble fine = tumble(known[0], 1.0 / 240, 20.0);
    const Tumble exact = tumble(known[1], 1.0 / 60, 20.0);
    const Tumble finest = tumble(known[1], 1.0 / 120, 20.0);
    CAPTURE(coarse.energy_error, fine.energy_error, exact.energy_error, finest.energy_error);
    CHECK(coarse.energy_error < 5e-4);
    CHECK(coarse.energy_error / fine.energy_error > 7.0);
    CHECK(exact.energy_error < 1e-6);
    CHECK(exact.energy_error / finest.energy_error > 25.0);
    CAPTURE(coarse.momentum_error);
    CHECK(coarse.momentum_error < 1e-13);
}

// A4. The middle component of the spin is an elliptic function of period 4 K(k) / rate (L. D.
// Landau, E. M. Lifshitz, Mechanics, section 37).
TEST_CASE("A tumbling box turns over in the time that theory gives") {
    const Model model = *build_model(one_solid(Vec3(0.5, 0.3, 0.1)), 1000.0);
    const Symmetric& inertia = model.bodies[0].inertia;
    const Vec3 spin(0.01, 8.0, 0.01);
    const Vec3 momentum(inertia.xx * spin.x(), inertia.yy * spin.y(), inertia.zz * spin.z());
    const double twice = spin.dot(momentum);
    const double square = momentum.squaredNorm();
    // The axis that the angular momentum goes round has the greater or the lesser inertia.
    const bool greater = square > twice * inertia.yy;
    const double far = greater ? inertia.zz : inertia.xx;
    const double near = greater ? inertia.xx : inertia.zz;
    const double rate = std::sqrt((far - inertia.yy) * (square - twice * near) /
                                  (inertia.xx * inertia.yy * inertia.zz));
    const double modulus = (inertia.yy - near) * (twice * far - square) /
                           ((far - inertia.yy) * (square - twice * near));
    double a = 1.0;
    double b = std::sqrt(1.0 - modulus);
    for (int i = 0; i < 30; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    const double half_period = 2.0 * (kPi / (2.0 * a)) / rate;

    Forcing forcing;
    Motion motion = rest_motion(model);
    set_coordinate_vector(motion.speed, momentum);
    Evaluation evaluation;
    MotionRate speeds;
    evaluate(model, forcing, motion, 0.0, evaluation, speeds);
    StepResult next;
    constexpr double step = 1.0 / 480;
    std::vector<double> crossings;
    double before = spin.y();
    for (int i = 0; i < 480 * 20; ++i) {
        const MotionSystem system{model, forcing, step};
        integrators()[1].attempt(system, {motion, speeds, 0.0, step, 1.0}, evaluation, next);
        motion = next.end;
        speeds = next.end_rate;
        restart_chart(model, motion);
        const Kinematics& k = evaluation.kinematics;
        set_coordinate_vector(speeds.position, k.spin[0]);
        const double now = k.turn[0].back(k.spin[0]).y();
        if (before * now < 0.0) crossings.push_back(step * (i + before / (before - now)));
        before = now;
    }
    REQUIRE(crossings.size() > 3);
    const double measured =
        (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    CAPTURE(measured, half_period, crossings.size());
    CHECK(measured == Approx(half_period).epsilon(1e-4));
}

namespace {

// Moves all stops out of reach.
BodyPlan without_stops(BodyPlan plan) {
    for (PlannedPart& part : plan.parts) {
        part.limit_low = -3.0;
        part.limit_high = 3.0;
        for (DegreeLimits& limits : part.further) {
            limits.low = -3.0;
            limits.high = 3.0;
        }
    }
    return plan;
}

void check_joints(const PhysicsScene& scene, const BodyPlan& plan) {
    for (std::size_t p = 1; p < plan.parts.size(); ++p) {
        const PlannedPart& part = plan.parts[p];
        if (part.motion == JointMotion::kSlide) continue;
        const Vec3 here = transform(scene.part_pose(p), part.anchor_in_child);
        const Vec3 there = transform(scene.part_pose(static_cast<std::size_t>(part.parent)),
                                     part.anchor_in_parent);
        CHECK((here - there).norm() < 1e-12);
    }
}

}  // namespace

// A9, A10, A11.
TEST_CASE("Muscles change no momentum, and all their work is energy") {
    for (const int parts : {6, 12, 24}) {
        RandomStream random(stream_seed({102, static_cast<std::uint64_t>(parts)}));
        const BodyPlan swung = random_solid(random, parts, 25000.0);
        for (const bool stops : {false, true}) {
            for (const bool exact : {false, true}) {
                const BodyPlan plan = stops ? swung : without_stops(swung);
                const auto scene = make_solid(
                    plan, weightless(),
                    settings_of(exact ? "dormand-prince" : "bogacki-shampine", stops   ? 4e-3
                                                                               : exact ? 1e-4
                                                                                       : 1e-3));
                SceneMotion motion = scene->motion();
                const std::size_t joints = motion.targets.size();
                for (std::size_t i = 0; i < 3; ++i)
                    motion.speeds[joints + i] = 20.0 * (static_cast<double>(i) - 0.7);
                REQUIRE(scene->begin_at(motion));
                const Vec3 center = scene->center_of_mass();
                const Vec3 momentum = angular_momentum(*scene, 1000.0);
                for (int tick = 0; tick < 600; ++tick) {
                    swing(*scene, swung);
                    REQUIRE(scene->advance(1.0 / 60) == SceneStatus::kRunning);
                }
                const SceneAudit& audit = scene->audit();
                const double residual = std::fabs(audit.energy_residual) / audit.gross_motor_work;
                CAPTURE(parts, stops, exact, residual, audit.evaluations, audit.steps,
                        audit.rejections, audit.max_limit_overrun, audit.fallbacks);
                CHECK((scene->center_of_mass() - center).norm() < 1e-10);
                CHECK((angular_momentum(*scene, 1000.0) - momentum).norm() <
                      1e-12 * momentum.norm());
                // Steps at stops are of second order.
                CHECK(residual < (stops ? 1e-2 : exact ? 1e-4 : 1e-3));
                CHECK(audit.max_limit_overrun < 0.03);
                CHECK(audit.fallbacks == 0);
                check_joints(*scene, plan);
            }
        }
    }
}

}  // namespace cambrian
