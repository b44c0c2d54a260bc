#include "planar/articulated/articulated_body.h"

#include "planar/articulated/least_squares_dynamics.h"
#include "planar/bodies.h"
#include "planar/model_building.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

struct RandomState {
    PlanarModel model;
    Kinematics kinematics;
    Loads loads;
};

RandomState random_state(RandomStream& random) {
    const int parts = random.between(3, 24);
    RandomState state{*build_planar_model(random_tree(random, parts, 0.4, 1.0, 0.0), 1.0), {}, {}};
    Motion motion = rest_motion(state.model);
    for (int c = 0; c < coordinate_count(state.model); ++c) {
        motion.position[c] += 0.5 * random.gauss();
        motion.speed[c] = 4.0 * random.gauss();
    }
    compute_kinematics(state.model, motion, state.kinematics);
    for (int i = 0; i < parts; ++i) {
        state.loads.force_x[i] = random.gauss();
        state.loads.force_y[i] = random.gauss();
        state.loads.torque[i] = random.gauss();
        state.loads.effort[i] = i == 0 ? 0.0 : random.gauss();
    }
    return state;
}

}  // namespace

TEST_CASE("the articulated body algorithm agrees with dense least squares",
          "[dynamics][articulated_body]") {
    RandomStream random(stream_seed({21}));
    for (int round = 0; round < 200; ++round) {
        const RandomState state = random_state(random);
        LeastSquaresDynamics reference(state.model, 1.0 / 30);
        const Eigen::VectorXd dense = reference.solve(state.kinematics, state.loads);
        CHECK(reference.deviation().norm() < 1e-12);
        Factors factors;
        BodyResponse response;
        solve_accelerations(state.model, state.kinematics, state.loads, factors, response);
        Eigen::VectorXd tree(dense.size());
        for (int i = 0; i < state.model.body_count; ++i)
            tree.segment<3>(3 * i) << response.x[i], response.y[i], response.spin[i];
        CHECK((tree - dense).norm() < 1e-9 * dense.norm());
    }
}

TEST_CASE("accelerations are the impulse response of the loads at rest",
          "[dynamics][articulated_body]") {
    RandomStream random(stream_seed({22}));
    for (int round = 0; round < 100; ++round) {
        RandomState state = random_state(random);
        for (int i = 0; i < state.model.body_count; ++i) {
            state.kinematics.gamma_x[i] = 0.0;
            state.kinematics.gamma_y[i] = 0.0;
            state.kinematics.spin[i] = 0.0;
        }
        Factors factors;
        BodyResponse accelerations;
        BodyResponse jumps;
        solve_accelerations(state.model, state.kinematics, state.loads, factors, accelerations);
        solve_impulse(state.model, state.kinematics, factors, state.loads, jumps);
        for (int c = 0; c < coordinate_count(state.model); ++c)
            CHECK(jumps.coordinate[c] ==
                  Approx(accelerations.coordinate[c]).epsilon(1e-9).margin(1e-9));
    }
}

namespace {

// Returns the inertia matrix of the coordinates: the matrix of the kinetic energy for unit rates.
Eigen::MatrixXd inertia_matrix(const PlanarModel& model, const Kinematics& place) {
    const int count = coordinate_count(model);
    Eigen::MatrixXd rates(3 * model.body_count, count);
    Eigen::VectorXd masses(3 * model.body_count);
    for (int c = 0; c < count; ++c) {
        PerCoordinate unit = {};
        unit[c] = 1.0;
        PerBody spin = {};
        PerBody x = {};
        PerBody y = {};
        spread_rates(model, place, unit, spin, x, y);
        for (int i = 0; i < model.body_count; ++i) {
            rates.col(c).segment<3>(3 * i) << x[i], y[i], spin[i];
            masses.segment<3>(3 * i) << model.mass[i], model.mass[i], model.inertia[i];
        }
    }
    return rates.transpose() * masses.asDiagonal() * rates;
}

// Returns the matrix that damping adds to the inertia matrix. Joints lose effort by a damping times
// their acceleration.
Eigen::MatrixXd damping_matrix(const PlanarModel& model, const PerBody& damping) {
    const int count = coordinate_count(model);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
    for (int i = 1; i < model.body_count; ++i) {
        Eigen::VectorXd joint = Eigen::VectorXd::Zero(count);
        joint(i) = 1.0;
        if (model.motion[i] == JointMotion::kTurn) {
            int turning = model.parent[i];  // the coordinate that turns the parent
            while (model.motion[turning] == JointMotion::kSlide)
                turning = model.parent[turning];
            joint(turning) = -1.0;
        }
        matrix += damping[i] * joint * joint.transpose();
    }
    return matrix;
}

Eigen::VectorXd coordinates_of(const PlanarModel& model, const BodyResponse& response) {
    return Eigen::Map<const Eigen::VectorXd>(response.coordinate, coordinate_count(model));
}

}  // namespace

TEST_CASE("implicit damping agrees with a dense solve of the coordinates",
          "[dynamics][articulated_body]") {
    RandomStream random(stream_seed({24}));
    for (int round = 0; round < 200; ++round) {
        const RandomState state = random_state(random);
        PerBody damping = {};
        for (int i = 1; i < state.model.body_count; ++i)
            damping[i] = random.chance(0.2) ? 0.0 : 3.0 * random.uniform() * state.model.inertia[i];
        const Eigen::MatrixXd inertia = inertia_matrix(state.model, state.kinematics);
        const auto dense =
            Eigen::LDLT<Eigen::MatrixXd>(inertia + damping_matrix(state.model, damping));
        Factors explicit_factors;
        Factors factors;
        BodyResponse free;
        BodyResponse damped;
        const auto agrees = [&] {
            const Eigen::VectorXd wanted = dense.solve(inertia * coordinates_of(state.model, free));
            return (coordinates_of(state.model, damped) - wanted).norm() < 1e-12 * wanted.norm();
        };
        solve_accelerations(state.model, state.kinematics, state.loads, explicit_factors, free);
        solve_damped_accelerations(state.model, state.kinematics, state.loads, damping, factors,
                                   damped);
        CHECK(agrees());
        solve_impulse(state.model, state.kinematics, explicit_factors, state.loads, free);
        solve_impulse(state.model, state.kinematics, factors, state.loads, damped);
        CHECK(agrees());
    }
}

TEST_CASE("two impulses side by side do what each does alone", "[dynamics][articulated_body]") {
    RandomStream random(stream_seed({24}));
    for (int round = 0; round < 100; ++round) {
        const RandomState state = random_state(random);
        RandomState other = state;
        PerBody damping = {};
        for (int i = 1; i < state.model.body_count; ++i) {
            damping[i] = 0.1 * random.uniform(0.0, 1.0);
            other.loads.force_x[i] = random.gauss();
            other.loads.torque[i] = random.gauss();
            other.loads.effort[i] = random.gauss();
        }
        Factors factors;
        BodyResponse unused;
        solve_damped_accelerations(state.model, state.kinematics, state.loads, damping, factors,
                                   unused);
        const Loads impulses[2] = {state.loads, other.loads};
        PerCoordinate jumps[2];
        solve_paired_impulses(state.model, state.kinematics, factors, impulses, jumps);
        for (int which = 0; which < 2; ++which) {
            BodyResponse alone;
            solve_impulse(state.model, state.kinematics, factors, impulses[which], alone);
            for (int c = 0; c < coordinate_count(state.model); ++c)
                CHECK(jumps[which][c] == Approx(alone.coordinate[c]).epsilon(1e-11).margin(1e-11));
        }
    }
}

TEST_CASE("the mean of the bodies' accelerations is that of the centre",
          "[dynamics][articulated_body]") {
    RandomStream random(stream_seed({23}));
    for (int round = 0; round < 100; ++round) {
        const RandomState state = random_state(random);
        Factors factors;
        BodyResponse response;
        solve_accelerations(state.model, state.kinematics, state.loads, factors, response);
        double mean = 0.0;
        for (int i = 0; i < state.model.body_count; ++i)
            mean += state.model.mass[i] * response.x[i] / state.model.total_mass;
        CHECK(mean ==
              Approx(response.coordinate[center_of(state.model, 0)]).epsilon(1e-8).margin(1e-8));
    }
}

TEST_CASE("the reference mode walks the same way", "[dynamics][articulated_body]") {
    BodyPlan plan = chain(4, 1.0);
    attach(plan, 1, Vec3(0.2, 0.0, 0.0), 0.5, kLinearJoint);
    plan.parts[4].limit_low = -0.1;
    plan.parts[4].limit_high = 0.1;
    for (PlannedPart& part : plan.parts)
        part.max_effort = 0.2;
    const auto end_of = [&](const std::string& integrator) {
        SceneSettings settings;
        settings.integrator = integrator;
        settings.tolerance = 1e-7;
        auto scene = make_scene(plan, empty_space(), settings);
        for (int tick = 0; tick < 40; ++tick) {
            flail(*scene, plan, 1.0);
            REQUIRE(scene->advance(kTestTick) == SceneStatus::kRunning);
        }
        return scene;
    };
    const auto tree = end_of("dormand-prince");
    const auto reference = end_of("least-squares");
    for (std::size_t i = 0; i < plan.parts.size(); ++i)
        CHECK((tree->part_pose(i).position - reference->part_pose(i).position).norm() < 1e-4);
}
