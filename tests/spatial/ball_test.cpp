#include "sensors/fake_surroundings.h"
#include "sensors/sensor.h"
#include "spatial/bodies.h"
#include "spatial/steps.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace cambrian {
namespace {

using namespace spatial;

BallAngles random_angles(RandomStream& random) {
    const double swing = random.uniform(0.0, 2.2);
    const double direction = random.uniform(-kPi, kPi);
    return {swing * std::cos(direction), swing * std::sin(direction), random.uniform(-2.6, 2.6)};
}

Vec3 random_spin(RandomStream& random) {
    return {random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
}

double difference(const BallAngles& a, const BallAngles& b) {
    return std::fmax(std::fmax(std::fabs(a.bend_z - b.bend_z), std::fabs(a.bend_y - b.bend_y)),
                     std::fabs(a.twist - b.twist));
}

}  // namespace

TEST_CASE("Swing and twist describe the attitude of a ball") {
    RandomStream random(stream_seed({120}));
    for (int turn = 0; turn < 500; ++turn) {
        const BallAngles angles = random_angles(random);
        const Rotation attitude = ball_attitude(angles);
        CHECK(difference(ball_angles(attitude), angles) < 1e-13);
        const Rotation negative(-attitude.w(), -attitude.x(), -attitude.y(), -attitude.z());
        CHECK(difference(ball_angles(negative), angles) < 1e-13);
        const Rotation other = ball_attitude(random_angles(random));
        const Rotation there = product(attitude, rotation_by(turn_between(attitude, other)));
        CHECK(there.angularDistance(other) < 1e-7);
    }
    // A turn through the attitude of rest, though the other way is shorter.
    const Vec3 back = turn_between(ball_attitude({0.0, 0.0, -2.0}), ball_attitude({0.0, 0.0, 2.0}));
    CHECK((back - Vec3(4.0, 0.0, 0.0)).norm() < 1e-14);
    CHECK(difference(ball_angles(Rotation::Identity()), {}) == 0.0);
}

TEST_CASE("The angles of a ball change as its spin says") {
    RandomStream random(stream_seed({121}));
    for (int turn = 0; turn < 500; ++turn) {
        const BallAngles angles = random_angles(random);
        if (angles.swing() < 0.3) continue;
        const Rotation attitude = ball_attitude(angles);
        const Vec3 spin = random_spin(random);
        constexpr double step = 1e-4;
        const auto at = [&](double time) {
            return product(rotation_by(Vec3(time * spin)), attitude);
        };
        const BallAngles before = ball_angles(at(-step));
        const BallAngles after = ball_angles(at(step));
        const BallAngles rates = ball_rates(attitude, spin);
        const double share = 0.5 / step;
        const BallAngles measured{share * (after.bend_z - before.bend_z),
                                  share * (after.bend_y - before.bend_y),
                                  share * (after.twist - before.twist)};
        CHECK(difference(measured, rates) < 1e-5);
        const BallDirections directions = ball_directions({}, turn_of(attitude), spin);
        CHECK(directions.twist.dot(spin) == Approx(rates.twist).margin(1e-12));
        CHECK(share * (after.swing() - before.swing()) ==
              Approx(directions.swing.dot(spin)).margin(1e-5));
        const double square = 1.0 / (step * step);
        CHECK(square * (after.swing() - 2.0 * angles.swing() + before.swing()) ==
              Approx(directions.swing_bias).epsilon(1e-4).margin(1e-4));
        CHECK(square * (after.twist - 2.0 * angles.twist + before.twist) ==
              Approx(directions.twist_bias).epsilon(1e-4).margin(1e-4));
    }
}

namespace {

constexpr double kHubMass = 1e12;  // kg; moves by 1e-12 of the others

// Boxes that hang from one another by balls, the first from a heavy hub which is pulled up, so that
// all hangs as under gravity.
class Pendulum {
public:
    Pendulum(int boxes, double half_width) {
        BodyPlan plan = one_solid(Vec3(0.1, 0.1, 0.1));
        for (int i = 0; i < boxes; ++i) {
            PlannedPart part;
            part.half_extents = Vec3(0.2, half_width, half_width);
            part.parent = i;
            part.motion = JointMotion::kBall;
            part.degree_count = 3;
            part.limit_high = 3.0;
            part.anchor_in_parent = Vec3(i == 0 ? 0.0 : 0.2, 0.0, 0.0);
            part.anchor_in_child = Vec3(-0.2, 0.0, 0.0);
            part.rest_pose.position = Vec3(0.2 + 0.4 * i, 0.0, 0.0);
            plan.parts.push_back(part);
        }
        model = *build_model(plan, 1000.0);
        model.mass += kHubMass - model.bodies[0].mass;
        model.bodies[0].mass = kHubMass;
        model.bodies[0].inertia = {kHubMass, kHubMass, kHubMass};
        motion = rest_motion(model);
        forcing.pulls[0] = {0, Vec3::Zero(), Vec3(0.0, kEarthGravity * model.mass, 0.0)};
        forcing.pull_count = 1;
    }

    // Gives a box its direction from the hub, with no twist, and a spin in the axes of the hub.
    void start(int body, const Vec3& direction, const Vec3& spin) {
        const Vec3 axis = Vec3::UnitX().cross(direction);
        const double angle = std::acos(direction.x());
        motion.ball[body].turn = rotation_by(Vec3(axis.normalized() * angle));
        const Vec3 own = motion.ball[body].turn.conjugate() * spin;
        const int first = model.bodies[body].first_degree;
        set_coordinate_vector(motion.speed + first, {own.z(), own.y(), own.x()});
    }

    // The hub does not turn.
    void begin() {
        compute_kinematics(model, motion, evaluation.kinematics);
        set_coordinate_vector(
            motion.speed + model.attitude(),
            -(evaluation.kinematics.whole_inertia * evaluation.kinematics.spin[0]));
        evaluate(model, forcing, motion, 0.0, evaluation, rate);
    }

    void step(double length) {
        const MotionSystem system{model, forcing, length};
        integrators()[1].attempt(system, {motion, rate, 0.0, length, 1.0}, evaluation, next);
        motion = next.end;
        rate = next.end_rate;
        restart_chart(model, motion);
        restart_chart_rates(model, motion, evaluation.kinematics.spin[0], rate);
    }

    Vec3 axis(int body) const { return evaluation.kinematics.turn[body].axis[0]; }

    double energy() const {
        const Kinematics& k = evaluation.kinematics;
        double sum = 0.0;
        for (int b = 1; b < model.body_count; ++b) {
            const Vec3 velocity = k.velocity[b] - k.velocity[0];
            sum += model.bodies[b].mass * (0.5 * velocity.squaredNorm() +
                                           kEarthGravity * (k.place[b] - k.place[0]).y()) +
                   0.5 * k.spin[b].dot(k.inertia[b] * k.spin[b]);
        }
        return sum;
    }
    // About the hub.
    Vec3 momentum() const {
        const Kinematics& k = evaluation.kinematics;
        Vec3 sum = Vec3::Zero();
        for (int b = 1; b < model.body_count; ++b)
            sum += k.inertia[b] * k.spin[b] +
                   model.bodies[b].mass *
                       (k.place[b] - k.place[0]).cross(k.velocity[b] - k.velocity[0]);
        return sum;
    }

    Model model;
    Motion motion;
    Forcing forcing;
    Evaluation evaluation;
    MotionRate rate;
    StepResult next;
};

// A symmetric top that hangs from a point: mass, distance of its centre and inertias.
struct Top {
    explicit Top(double half_width)
        : mass(1000.0 * 0.4 * 4.0 * half_width * half_width),
          weight(mass * kEarthGravity * 0.2),
          along(mass * 2.0 / 3.0 * half_width * half_width),
          across(mass / 3.0 * (0.2 * 0.2 + half_width * half_width) + mass * 0.2 * 0.2) {}
    double mass, weight, along, across;  // kg, N m, kg m^2 about the point
};

}  // namespace

// A5.
TEST_CASE("A conical pendulum on a ball goes round as theory says") {
    const Top top(0.03);
    constexpr double tilt = 0.7;
    const double turning = std::sqrt(top.weight / ((top.across - top.along) * std::cos(tilt)));
    Pendulum pendulum(1, 0.03);
    const Vec3 start(std::sin(tilt), -std::cos(tilt), 0.0);
    pendulum.start(1, start, Vec3(0.0, turning, 0.0));
    pendulum.begin();
    const double step = 5.0 * 2.0 * kPi / turning / 1000.0;
    double apart = 0.0;
    for (int i = 1; i <= 1000; ++i) {
        pendulum.step(step);
        const Vec3 expected = rotation_by(Vec3(0.0, i * step * turning, 0.0)) * start;
        apart = std::fmax(apart, 0.4 * (pendulum.axis(1) - expected).norm());
    }
    CAPTURE(apart);
    CHECK(apart < 1e-10);
}

// A6.
TEST_CASE("A heavy gyroscope on a ball precesses as theory says") {
    const Top top(0.2);
    constexpr double tilt = 0.6;
    constexpr double spin = 60.0;
    const double drive = top.along * spin;
    const double lean = top.across * std::cos(tilt);
    const double turning =
        (drive - std::sqrt(drive * drive - 4.0 * lean * top.weight)) / (2.0 * lean);
    const Vec3 start(std::sin(tilt), std::cos(tilt), 0.0);
    Pendulum pendulum(1, 0.2);
    pendulum.start(1, start, spin * start + turning * (Vec3::UnitY() - std::cos(tilt) * start));
    pendulum.begin();
    constexpr double step = 1.0 / 240;
    double apart = 0.0;
    for (int i = 1; i <= 5 * 240; ++i) {
        pendulum.step(step);
        const Vec3 expected = rotation_by(Vec3(0.0, i * step * turning, 0.0)) * start;
        apart = std::fmax(apart, (pendulum.axis(1) - expected).norm());
    }
    CAPTURE(apart, turning);
    CHECK(turning > 1.0);
    CHECK(apart < 1e-4);
}

// A7. With u, the height of the axis, u'^2 is a cubic of u (L. D. Landau, E. M. Lifshitz,
// Mechanics, section 35); its roots are the heights where u turns.
TEST_CASE("A spherical pendulum keeps its energy and its momentum about the vertical") {
    const Top top(0.03);
    Pendulum pendulum(1, 0.03);
    pendulum.start(1, Vec3(0.8, -0.6, 0.0), Vec3(1.0, 3.0, -2.0));
    pendulum.begin();
    const double energy = pendulum.energy();
    const Vec3 momentum = pendulum.momentum();
    const double about_axis = momentum.dot(pendulum.axis(1));
    double energy_error = 0.0;
    double momentum_error = 0.0;
    double cubic_error = 0.0;
    double low = 1.0;
    double high = -1.0;
    for (int i = 0; i < 20 * 120; ++i) {
        pendulum.step(1.0 / 120);
        energy_error = std::fmax(energy_error, std::fabs(pendulum.energy() - energy));
        momentum_error =
            std::fmax(momentum_error, std::fabs(pendulum.momentum().y() - momentum.y()));
        const Vec3 axis = pendulum.axis(1);
        const double rate = pendulum.evaluation.kinematics.spin[1].cross(axis).y();
        const double u = axis.y();
        const double left =
            (1.0 - u * u) *
                (2.0 * (energy - top.weight * u) - about_axis * about_axis / top.along) /
                top.across -
            std::pow((momentum.y() - about_axis * u) / top.across, 2);
        cubic_error = std::fmax(cubic_error, std::fabs(rate * rate - left));
        low = std::fmin(low, u);
        high = std::fmax(high, u);
    }
    CAPTURE(energy, energy_error, momentum.y(), momentum_error, cubic_error, low, high);
    CHECK(high - low > 0.1);
    CHECK(energy_error < 1e-6 * std::fabs(energy));
    CHECK(momentum_error < 1e-6 * std::fabs(momentum.y()));
    CHECK(cubic_error < 1e-4);
}

// A8.
TEST_CASE("Two boxes that hang by balls keep their energy and their momentum about the vertical") {
    const auto errors = [](int steps) {
        Pendulum pendulum(2, 0.03);
        pendulum.start(1, Vec3(0.8, 0.6, 0.0), Vec3(1.0, 2.0, -1.0));
        pendulum.start(2, Vec3(0.6, 0.0, 0.8), Vec3(-2.0, 1.0, 1.0));
        pendulum.begin();
        const double energy = pendulum.energy();
        const double momentum = pendulum.momentum().y();
        double worst = 0.0;
        for (int i = 0; i < 20 * steps; ++i) {
            pendulum.step(1.0 / steps);
            worst = std::fmax(worst, std::fabs(pendulum.energy() / energy - 1.0));
            worst = std::fmax(worst, std::fabs(pendulum.momentum().y() / momentum - 1.0));
        }
        return worst;
    };
    const double coarse = errors(240);
    const double fine = errors(480);
    CAPTURE(coarse, fine);
    CHECK(fine < 1e-5);
    CHECK(coarse > 8.0 * fine);
}

namespace {

// A heavy box on the ground with a limp limb on its side, which falls to its cone.
BodyPlan limp_limb(double cone) {
    BodyPlan plan = one_solid(Vec3(0.4, 0.5, 0.4));
    plan.parts.front().rest_pose.position.y() = 0.5;
    PlannedPart limb;
    limb.half_extents = Vec3(0.2, 0.05, 0.05);
    limb.parent = 0;
    limb.motion = JointMotion::kBall;
    limb.degree_count = 3;
    limb.limit_low = -cone;
    limb.limit_high = cone;
    limb.further = {DegreeLimits{-cone, cone, 0.0}, DegreeLimits{-2.5, 2.5, 0.0}};
    limb.anchor_in_parent = Vec3(0.4, 0.4, 0.0);
    limb.anchor_in_child = Vec3(-0.2, 0.0, 0.0);
    limb.rest_pose.position = Vec3(0.6, 0.9, 0.0);
    plan.parts.push_back(limb);
    return plan;
}

}  // namespace

// A20, also pushed to the side, so that the limb goes round its cone.
TEST_CASE("A limp ball hangs at its cone") {
    for (const double cone : {0.05, 0.2, 0.7, 1.4}) {
        for (const double push : {0.0, 3.0, 6.0}) {
            const auto scene = make_solid(limp_limb(cone), spatial_ground(0.8, 0.2));
            SceneMotion motion = scene->motion();
            motion.speeds[1] = push;
            REQUIRE(scene->begin_at(motion));
            double widest = 0.0;
            for (int tick = 0; tick < 600; ++tick) {
                run_ticks(*scene, 1);
                const double z = scene->joint_coordinate(JointDegree{1, 0});
                const double y = scene->joint_coordinate(JointDegree{1, 1});
                widest = std::fmax(widest, std::sqrt(z * z + y * y));
                if (tick == 599 && push == 0.0) CHECK(z == Approx(-cone).margin(1e-6));
            }
            const SceneAudit& audit = scene->audit();
            const double residual = std::fabs(audit.energy_residual) / audit.energy_scale;
            CAPTURE(cone, push, widest - cone, residual);
            // A step crosses a third of the narrowest.
            CHECK(widest - cone < (cone < 0.1 ? 0.03 : 0.01));
            CHECK(residual < 1e-2);
            CHECK(audit.fallbacks == 0);
        }
    }
}

// A19.
TEST_CASE("A chain of limp balls comes to rest") {
    BodyPlan plan = one_solid(Vec3(0.15, 0.05, 0.05));
    for (int i = 1; i < 6; ++i) {
        PlannedPart part = limp_limb(1.2).parts[1];
        part.half_extents = Vec3(0.15, 0.05, 0.05);
        part.parent = i - 1;
        part.anchor_in_parent = Vec3(0.15, 0.0, 0.0);
        part.anchor_in_child = Vec3(-0.15, 0.0, 0.0);
        part.rest_pose.position = Vec3(0.3 * i, 0.0, 0.0);
        plan.parts.push_back(part);
    }
    for (const double turn : {0.3, 1.3, 2.3}) {
        const auto scene = make_solid(turned_plan(plan, rotation_by(Vec3(turn, 0.4, 0.9))),
                                      spatial_ground(0.8, 0.2));
        scene->translate({0.0, 1.5 - scene->lowest_point(), 0.0});
        const double energy = scene->energy();
        run_ticks(*scene, 1200);
        double fastest = 0.0;
        for (std::size_t p = 0; p < plan.parts.size(); ++p)
            fastest = std::fmax(fastest, scene->part_twist(p).linear.norm());
        const SceneAudit& audit = scene->audit();
        const double residual = std::fabs(audit.energy_residual) / energy;
        CAPTURE(turn, fastest, residual, audit.max_limit_overrun, audit.evaluations);
        CHECK(fastest < 1e-3);
        // Universal joints in place of the balls leave as much (spatial/README.md 8).
        CHECK(residual < 6e-3);
        CHECK(audit.max_limit_overrun < 0.03);
    }
}

// C9.
TEST_CASE("A ball that cannot twist moves like a universal joint") {
    const auto plan_of = [](bool ball) {
        BodyPlan plan = one_solid(Vec3(0.3, 0.1, 0.1));
        PlannedPart part = limp_limb(1.0).parts[1];
        part.half_extents = Vec3(0.2, 0.06, 0.06);
        part.anchor_in_parent = Vec3(0.3, 0.0, 0.0);
        part.rest_pose.position = Vec3(0.5, 0.0, 0.0);
        part.max_effort = 20.0;
        part.further[0].max_effort = 20.0;
        part.further[1] = {-0.001, 0.001, 20.0};
        if (!ball) {
            part.motion = JointMotion::kTurn;
            part.degree_count = 2;
        }
        plan.parts.push_back(part);
        return plan;
    };
    const auto ball = make_solid(plan_of(true), weightless());
    const auto universal = make_solid(plan_of(false), weightless());
    double apart = 0.0;
    double moved = 0.0;
    for (int tick = 0; tick < 60; ++tick) {
        const double time = tick / 60.0;
        for (const auto* scene : {&ball, &universal}) {
            (*scene)->set_target(JointDegree{1, 0}, 0.3 * sine(5.0 * time));
            (*scene)->set_target(JointDegree{1, 1}, 0.3 * sine(4.0 * time));
            run_ticks(**scene, 1);
        }
        apart = std::fmax(
            apart, (point_on_axis(*ball, 1, 1.0) - point_on_axis(*universal, 1, 1.0)).norm());
        moved = std::fmax(moved, std::fabs(ball->joint_coordinate(JointDegree{1, 1})));
    }
    CAPTURE(apart, moved);
    CHECK(moved > 0.1);
    CHECK(apart < 0.01);
}

TEST_CASE("Sensors tell the angles of a ball, their rates and efforts") {
    BodyPlan plan = limp_limb(1.0);
    plan.parts[1].max_effort = 50.0;
    plan.parts[1].further[0].max_effort = 40.0;
    plan.parts[1].further[1].max_effort = 30.0;
    const auto scene = make_solid(plan, weightless());
    for (std::uint8_t d = 0; d < 3; ++d)
        scene->set_target(JointDegree{1, d}, 0.3 + 0.1 * d);
    run_ticks(*scene, 8);
    const FakeSurroundings surroundings;
    const SensorRegistry sensors = spatial_sensors();
    const auto read = [&](const std::string& id, const Mirror& mirror) {
        double memory = 0.0;
        for (const SensorKind& kind : sensors.all()) {
            for (std::size_t channel = 0; channel < kind.channels.size(); ++channel) {
                if (kind.channels[channel].id == id)
                    return kind.read({*scene, surroundings, plan.parts[1], 1, channel, mirror, 1.0},
                                     memory);
            }
        }
        FAIL("no channel " << id);
        return 0.0;
    };
    for (std::uint8_t d = 0; d < 3; ++d) {
        const std::string number = d == 0 ? "" : "-" + std::to_string(d + 1);
        const JointDegree degree{1, d};
        const double most = limits_of(plan.parts[1], d).max_effort;
        CHECK(std::fabs(scene->joint_rate(degree)) > 0.1);
        CHECK(std::fabs(scene->joint_effort(degree)) > 1e-3);
        for (const int across : {1, -1}) {
            for (const int depth : {1, -1}) {
                const Mirror mirror{across, depth};
                const int sign = mirror.of_turn(2 - d);
                const auto reading = [&](const char* id) {
                    return sign * read(id + number, mirror);
                };
                CHECK(reading("joint") == scene->joint_coordinate(degree));
                CHECK(reading("joint-rate") == Approx(scene->joint_rate(degree) / 6.0));
                CHECK(reading("effort") == Approx(scene->joint_effort(degree) / most));
            }
        }
    }
}

TEST_CASE("The position of a ball goes to its targets, which stay in its cone") {
    BodyPlan plan = limp_limb(0.8);
    plan.parts[1].max_effort = 100.0;
    for (DegreeLimits& limits : plan.parts[1].further)
        limits.max_effort = 100.0;
    const auto scene = make_solid(plan, weightless());
    const auto angle = [&](std::uint8_t degree) {
        return scene->joint_coordinate(JointDegree{1, degree});
    };
    const auto aim = [&](double bend_z, double bend_y, double twist) {
        scene->set_target(JointDegree{1, 0}, bend_z);
        scene->set_target(JointDegree{1, 1}, bend_y);
        scene->set_target(JointDegree{1, 2}, twist);
        run_ticks(*scene, 180);
    };
    aim(0.3, -0.4, 0.6);
    CHECK(angle(0) == Approx(0.3).margin(1e-3));
    CHECK(angle(1) == Approx(-0.4).margin(1e-3));
    CHECK(angle(2) == Approx(0.6).margin(1e-3));
    aim(0.8, 0.8, -0.6);
    CHECK(angle(0) == Approx(0.8 * std::sqrt(0.5)).margin(2e-3));
    CHECK(angle(1) == Approx(0.8 * std::sqrt(0.5)).margin(2e-3));
    CHECK(angle(2) == Approx(-0.6).margin(1e-3));
    const auto copy = make_solid(plan, weightless());
    REQUIRE(copy->begin_at(scene->motion()));
    CHECK((copy->part_axis(1) - scene->part_axis(1)).norm() < 1e-14);
    SceneMotion broken = scene->motion();
    for (std::size_t i = broken.positions.size() - 4; i < broken.positions.size(); ++i)
        broken.positions[i] = 0.0;
    CHECK(!copy->begin_at(broken));
}

}  // namespace cambrian
