#include "dynamics/elimination.h"

#include "dynamics/bodies.h"
#include "dynamics/model_building.h"
#include "support/catch.h"

#include <Eigen/Dense>

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

// The constraint-force equation as it is written (physics.md 4.1): dense, in three coordinates a
// body, solved by least squares; tau terms vanish because the joints are together.
Eigen::VectorXd dense_accelerations(const RandomState& state) {
    const PlanarModel& m = state.model;
    const Kinematics& k = state.kinematics;
    const int n = m.body_count;
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(2 * (n - 1), 3 * n);
    Eigen::VectorXd beta = Eigen::VectorXd::Zero(2 * (n - 1));
    Eigen::VectorXd inverse_mass(3 * n);
    Eigen::VectorXd force(3 * n);
    for (int i = 0; i < n; ++i) {
        inverse_mass.segment<3>(3 * i) << 1 / m.mass[i], 1 / m.mass[i], 1 / m.inertia[i];
        force.segment<3>(3 * i) << state.loads.force_x[i], state.loads.force_y[i],
            state.loads.torque[i];
    }
    for (int i = 1; i < n; ++i) {
        const int p = m.parent[i];
        const int row = 2 * (i - 1);
        const Vec2 z(k.z_x[i], k.z_y[i]);
        const Vec2 s(k.s_x[i], k.s_y[i]);
        const Vec2 gamma(k.gamma_x[i], k.gamma_y[i]);
        const double effort = state.loads.effort[i];
        if (m.joint[i] == JointType::kRotary) {
            // a_i - a_p - z alpha_p - s alpha_i = gamma
            jacobian.block<2, 2>(row, 3 * i).setIdentity();
            jacobian.block<2, 2>(row, 3 * p) = -Mat2::Identity();
            jacobian.block<2, 1>(row, 3 * p + 2) = -z;
            jacobian.block<2, 1>(row, 3 * i + 2) = -s;
            beta.segment<2>(row) = -gamma;
            force(3 * i + 2) += effort;
            force(3 * p + 2) -= effort;
        } else {
            // Across the axis, and no turning against the parent.
            const Vec2 across(-s.y(), s.x());
            jacobian.block<1, 2>(row, 3 * i) = across.transpose();
            jacobian.block<1, 2>(row, 3 * p) = -across.transpose();
            jacobian(row, 3 * p + 2) = -across.dot(z);
            beta(row) = -across.dot(gamma);
            jacobian(row + 1, 3 * i + 2) = 1.0;
            jacobian(row + 1, 3 * p + 2) = -1.0;
            force.segment<2>(3 * i) += effort * s;
            force.segment<2>(3 * p) -= effort * s;
            force(3 * p + 2) -= effort * z.dot(s);
        }
    }
    const Eigen::MatrixXd weighted = jacobian * inverse_mass.asDiagonal();
    const Eigen::VectorXd right = -(weighted * force + beta);
    const Eigen::VectorXd lambda =
        (weighted * jacobian.transpose()).completeOrthogonalDecomposition().solve(right);
    return inverse_mass.cwiseProduct(force + jacobian.transpose() * lambda);
}

}  // namespace

TEST_CASE("tree elimination agrees with dense least squares", "[dynamics][elimination]") {
    RandomStream random(stream_seed({21}));
    for (int round = 0; round < 200; ++round) {
        const RandomState state = random_state(random);
        const Eigen::VectorXd dense = dense_accelerations(state);
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
          "[dynamics][elimination]") {
    RandomStream random(stream_seed({22}));
    for (int round = 0; round < 100; ++round) {
        RandomState state = random_state(random);
        for (int i = 1; i < state.model.body_count; ++i) {
            state.kinematics.gamma_x[i] = 0.0;
            state.kinematics.gamma_y[i] = 0.0;
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

TEST_CASE("the mean of the bodies' accelerations is that of the centre",
          "[dynamics][elimination]") {
    RandomStream random(stream_seed({23}));
    for (int round = 0; round < 100; ++round) {
        const RandomState state = random_state(random);
        Factors factors;
        BodyResponse response;
        solve_accelerations(state.model, state.kinematics, state.loads, factors, response);
        double mean = 0.0;
        for (int i = 0; i < state.model.body_count; ++i)
            mean += state.model.mass[i] * response.x[i] / state.model.total_mass;
        CHECK(mean == Approx(response.coordinate[0]).epsilon(1e-8).margin(1e-8));
    }
}
