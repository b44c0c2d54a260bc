#include "planar/articulated/least_squares_dynamics.h"

#include "math/types.h"

#include <Eigen/QR>

namespace cambrian {
namespace {

// Pivots below this share of the largest mark redundant rows. Rounding and small gaps make equal
// constraints slightly different.
constexpr double kLeastSquaresRankThreshold = 1e-10;

Vec2 perp(const Vec2& v) {
    return {-v.y(), v.x()};
}

// Rotates a vector from a body's frame to the world.
Vec2 to_world(const Kinematics& k, Eigen::Index body, double x, double y) {
    return {k.cosine[body] * x - k.sine[body] * y, k.sine[body] * x + k.cosine[body] * y};
}

Vec2 place(const Kinematics& k, Eigen::Index body) {
    return {k.x[body], k.y[body]};
}

Vec2 velocity(const Kinematics& k, Eigen::Index body) {
    return {k.velocity_x[body], k.velocity_y[body]};
}

}  // namespace

LeastSquaresDynamics::LeastSquaresDynamics(const PlanarModel& model, double time_constant)
    : model_(model), time_constant_(time_constant) {
    const Eigen::Index bodies = model.body_count;
    const Eigen::Index columns = 3 * bodies;
    const Eigen::Index rows = 2 * (bodies - model.tree_count);
    inverse_mass_.resize(columns);
    for (Eigen::Index i = 0; i < bodies; ++i)
        inverse_mass_.segment<3>(3 * i) << 1.0 / model.mass[i], 1.0 / model.mass[i],
            1.0 / model.inertia[i];
    force_.resize(columns);
    accelerations_.resize(columns);
    jacobian_.resize(rows, columns);
    deviation_.resize(rows);
    rate_.resize(rows);
    bias_.resize(rows);
}

// D = c_p + r_p - c_i - r_c.
void LeastSquaresDynamics::add_revolute(const Kinematics& k, Eigen::Index row, int body,
                                        double effort) {
    const Eigen::Index i = body;
    const Eigen::Index p = model_.parent[i];
    const Vec2 parent_arm = to_world(k, p, model_.parent_anchor_x[i], model_.parent_anchor_y[i]);
    const Vec2 child_arm = to_world(k, i, model_.child_anchor_x[i], model_.child_anchor_y[i]);
    jacobian_.block<2, 2>(row, 3 * p).setIdentity();
    jacobian_.block<2, 1>(row, 3 * p + 2) = perp(parent_arm);
    jacobian_.block<2, 2>(row, 3 * i) = -Mat2::Identity();
    jacobian_.block<2, 1>(row, 3 * i + 2) = -perp(child_arm);
    deviation_.segment<2>(row) = place(k, p) + parent_arm - place(k, i) - child_arm;
    bias_.segment<2>(row) = k.spin[i] * k.spin[i] * child_arm - k.spin[p] * k.spin[p] * parent_arm;
    force_(3 * i + 2) += effort;
    force_(3 * p + 2) -= effort;
}

// With delta = c_i + r_c - c_p - r_p and m = perp(axis): D = (m delta, theta_i - theta_p - theta0).
void LeastSquaresDynamics::add_prismatic(const Kinematics& k, Eigen::Index row, int body,
                                         double effort) {
    const Eigen::Index i = body;
    const Eigen::Index p = model_.parent[i];
    const Vec2 axis = to_world(k, p, model_.axis_x[i], model_.axis_y[i]);
    const Vec2 across = perp(axis);
    const Vec2 parent_arm = to_world(k, p, model_.parent_anchor_x[i], model_.parent_anchor_y[i]);
    const Vec2 child_arm = to_world(k, i, model_.child_anchor_x[i], model_.child_anchor_y[i]);
    const Vec2 delta = place(k, i) + child_arm - place(k, p) - parent_arm;
    const Vec2 delta_rate = velocity(k, i) + k.spin[i] * perp(child_arm) - velocity(k, p) -
                            k.spin[p] * perp(parent_arm);
    const double spin = k.spin[p];
    jacobian_.block<1, 2>(row, 3 * i) = across.transpose();
    jacobian_(row, 3 * i + 2) = across.dot(perp(child_arm));
    jacobian_.block<1, 2>(row, 3 * p) = -across.transpose();
    jacobian_(row, 3 * p + 2) = perp(across).dot(delta) - across.dot(perp(parent_arm));
    jacobian_(row + 1, 3 * i + 2) = 1.0;
    jacobian_(row + 1, 3 * p + 2) = -1.0;
    deviation_(row) = across.dot(delta);
    deviation_(row + 1) = k.angle[i] - k.angle[p] - model_.rest_angle[i];
    bias_(row) = 2.0 * spin * perp(across).dot(delta_rate) - spin * spin * across.dot(delta) +
                 across.dot(spin * spin * parent_arm - k.spin[i] * k.spin[i] * child_arm);
    bias_(row + 1) = 0.0;
    // The force acts along the axis, on the line through the child's centre.
    const Vec2 push = effort * axis;
    force_.segment<2>(3 * i) += push;
    force_.segment<2>(3 * p) -= push;
    force_(3 * p + 2) -= perp(place(k, i) - place(k, p)).dot(push);
}

// (J M^-1 J') lambda = -(J M^-1 F + beta + 2/tau D' + D/tau^2).
const Eigen::VectorXd& LeastSquaresDynamics::solve(const Kinematics& bodies, const Loads& loads) {
    Eigen::VectorXd speeds(force_.size());
    jacobian_.setZero();
    for (Eigen::Index i = 0; i < model_.body_count; ++i) {
        force_.segment<3>(3 * i) << loads.force_x[i], loads.force_y[i], loads.torque[i];
        speeds.segment<3>(3 * i) << bodies.velocity_x[i], bodies.velocity_y[i], bodies.spin[i];
    }
    Eigen::Index row = 0;
    for (int i = 0; i < model_.body_count; ++i) {
        if (model_.parent[i] < 0) continue;
        if (model_.motion[i] == JointMotion::kSlide)
            add_prismatic(bodies, row, i, loads.effort[i]);
        else
            add_revolute(bodies, row, i, loads.effort[i]);
        row += 2;
    }
    accelerations_ = inverse_mass_.cwiseProduct(force_);
    if (row == 0) return accelerations_;
    rate_ = jacobian_ * speeds;
    const Eigen::VectorXd right =
        -(jacobian_ * accelerations_ + bias_ + 2.0 / time_constant_ * rate_ +
          deviation_ / (time_constant_ * time_constant_));
    const Eigen::MatrixXd matrix = jacobian_ * inverse_mass_.asDiagonal() * jacobian_.transpose();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(kLeastSquaresRankThreshold);
    const Eigen::VectorXd lambda = decomposition.compute(matrix).solve(right);
    accelerations_ += inverse_mass_.cwiseProduct(jacobian_.transpose() * lambda);
    return accelerations_;
}

}  // namespace cambrian
