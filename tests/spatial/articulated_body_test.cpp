#include "spatial/bodies.h"
#include "spatial/evaluation.h"

#include <catch2/catch.hpp>

namespace cambrian {
namespace {

using namespace spatial;

// Accelerations of a body's centre of mass and of its turning, by the classical rules of relative
// motion, which the elimination does not use.
struct BodyAcceleration {
    Vec3 linear = Vec3::Zero(), turning = Vec3::Zero();
};

BodyAcceleration follow(const Model& model, const Motion& motion, const MotionRate& rate,
                        const Kinematics& k, int b, const BodyAcceleration& parent) {
    const Body& body = model.bodies[b];
    Turn frame = k.turn[body.parent] * body.joint_frame;
    Vec3 arm = k.turn[body.parent] * body.pivot_in_parent;
    Vec3 spin = k.spin[body.parent];
    BodyAcceleration own = parent;
    Vec3 sliding = Vec3::Zero();
    if (body.is_ball) {
        frame = frame * turn_of(ball_attitude(model, motion, b));
        const Vec3 relative = frame * ball_vector(motion.speed + body.first_degree);
        own.turning += frame * ball_vector(rate.speed + body.first_degree) + spin.cross(relative);
        spin += relative;
    }
    const int hinges = body.is_ball ? 0 : body.degree_count;
    for (int d = body.first_degree; d < body.first_degree + hinges; ++d) {
        const Vec3 axis = frame.axis[model.degrees[d].axis];
        if (model.degrees[d].slides) {
            arm += motion.position[d] * axis;
            sliding = rate.speed[d] * axis + 2.0 * motion.speed[d] * spin.cross(axis);
            continue;
        }
        own.turning += rate.speed[d] * axis + motion.speed[d] * spin.cross(axis);
        spin += motion.speed[d] * axis;
        frame.turn_about(model.degrees[d].axis, sine_cosine(motion.position[d]));
    }
    const Vec3 back = frame * body.pivot_in_body;
    const Vec3& before = k.spin[body.parent];
    own.linear += parent.turning.cross(arm) + before.cross(before.cross(arm)) + sliding -
                  own.turning.cross(back) - spin.cross(spin.cross(back));
    return own;
}

double largest(double a, const Vec3& v) {
    return std::fmax(a, v.cwiseAbs().maxCoeff());
}

}  // namespace

// A1. The forces that the accelerations need are those that act: none across the hinges but the
// efforts of motors, and none on the whole but drag and gravity.
TEST_CASE("Accelerations of random bodies satisfy the equations of motion") {
    RandomStream random(stream_seed({101}));
    double worst = 0.0;
    for (int turn = 0; turn < 400; ++turn) {
        const auto plan = random_solid(random, random.between(2, 24), 25000.0);
        const auto built = build_model(plan, 1000.0);
        REQUIRE(built);
        const Model& model = *built;
        Motion motion = rest_motion(model);
        for (int c = 0; c < model.coordinate_count(); ++c) {
            motion.position[c] += random.uniform(-1.0, 1.0);
            motion.speed[c] = random.uniform(-4.0, 4.0);
        }
        Forcing forcing;
        forcing.medium = {Vec3(1.0, -9.81, 2.0), 200.0, 1000.0};
        forcing.drive.frequency = 25.0;
        forcing.drive.speed_limit = 6.0;
        for (int d = 0; d < model.degree_count; ++d)
            forcing.drive.end[d] = random.uniform(-1.0, 1.0);
        Evaluation evaluation;
        MotionRate rate;
        evaluate(model, forcing, motion, 0.4, evaluation, rate);
        const Kinematics& k = evaluation.kinematics;
        std::vector<BodyAcceleration> bodies(static_cast<std::size_t>(model.body_count));
        bodies[0].turning = rate.root_turning;
        Vec3 mean = Vec3::Zero();
        for (int b = 0; b < model.body_count; ++b) {
            if (b > 0)
                bodies[static_cast<std::size_t>(b)] =
                    follow(model, motion, rate, k, b,
                           bodies[static_cast<std::size_t>(model.bodies[b].parent)]);
            mean += model.bodies[b].mass / model.mass * bodies[static_cast<std::size_t>(b)].linear;
        }
        const Vec3 center = coordinate_vector(rate.speed + model.place());
        // What is missing of the force and the moment (about the centre of mass of all).
        std::vector<Six> missing(static_cast<std::size_t>(model.body_count));
        double scale = 0.0;
        for (int b = 0; b < model.body_count; ++b) {
            const BodyAcceleration& own = bodies[static_cast<std::size_t>(b)];
            const Vec3 force =
                model.bodies[b].mass * (own.linear - mean + center - forcing.medium.gravity);
            const Vec3 moment = k.inertia[b] * own.turning +
                                k.spin[b].cross(k.inertia[b] * k.spin[b]) + k.place[b].cross(force);
            missing[static_cast<std::size_t>(b)] = {moment - evaluation.loads.wrench[b].angular,
                                                    force - evaluation.loads.wrench[b].linear};
            scale = largest(largest(scale, moment), force);
        }
        for (int b = model.body_count - 1; b > 0; --b) {
            const Body& body = model.bodies[b];
            const Six& own = missing[static_cast<std::size_t>(b)];
            for (int d = body.first_degree; d < body.first_degree + body.degree_count; ++d)
                worst = std::fmax(
                    worst,
                    std::fabs(spatial::dot(k.axis[d], own) - evaluation.loads.effort[d]) / scale);
            missing[static_cast<std::size_t>(body.parent)] += own;
        }
        worst = largest(worst, missing[0].angular / scale);
        worst = largest(worst, missing[0].linear / scale);
    }
    CAPTURE(worst);
    CHECK(worst < 1e-9);
}

// A12, A13.
TEST_CASE("Drag on a plate is that of its area") {
    const auto plan = one_solid(Vec3(0.3, 0.2, 0.01));
    Environment environment = weightless();
    environment.gravity = 9.81;
    environment.gravity_direction = -90.0;
    environment.viscosity_quadratic = 1000.0;
    auto flat = plan;
    flat.parts[0].rest_pose.orientation = spatial::rotation_by(Vec3(0.5 * kPi, 0.0, 0.0));
    const auto scene = make_solid(flat, environment);
    for (int tick = 0; tick < 600; ++tick)
        REQUIRE(scene->advance(1.0 / 60) == SceneStatus::kRunning);
    const double area = 0.6 * 0.4;
    const double speed = std::sqrt(scene->mass() * 9.81 / (1000.0 * area));
    CHECK(-scene->center_of_mass_velocity().y() == Approx(speed).epsilon(1e-5));

    Model model = *build_model(plan, 1000.0);
    Motion motion = rest_motion(model);
    Kinematics k;
    compute_kinematics(model, motion, k);
    const double spin = 3.0;
    set_coordinate_vector(motion.speed, k.whole_inertia * Vec3(spin, 0.0, 0.0));
    compute_kinematics(model, motion, k);
    Loads loads;
    add_drag(model, {Vec3::Zero(), 0.0, 1000.0}, k, Vec3::Zero(), loads);
    const double broad = 1000.0 * spin * spin * 0.6 * std::pow(0.2, 4) / 2.0;
    const double narrow = 1000.0 * spin * spin * 0.6 * std::pow(0.01, 4) / 2.0;
    CHECK(-loads.wrench[0].angular.x() == Approx(broad + narrow).epsilon(0.04));
    CHECK(loads.wrench[0].angular.y() == 0.0);
}

}  // namespace cambrian
