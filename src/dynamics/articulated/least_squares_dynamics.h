#pragma once

// The constraint-force equation as it is written (physics.md 4.1), in three dependent coordinates a
// body, solved in the least-squares sense: any topology, with closing pins and redundant ones. It
// tolerates joints that have come apart, and draws them together again; slow, and the reference for
// the tree elimination.

#include "dynamics/articulated/elimination.h"

#include <Eigen/Core>

namespace cambrian {

class LeastSquaresDynamics {
public:
    // time_constant in s: how fast joints that are apart close.
    LeastSquaresDynamics(const PlanarModel& model, double time_constant);

    // Accelerations (x, y, spin of every body) of bodies placed and moving as the kinematics say;
    // of those only places, angles and speeds are read.
    const Eigen::VectorXd& solve(const Kinematics& bodies, const Loads& loads);

    // How far apart the joints are: m and rad, two rows a joint, then two a closing pin. Filled by
    // solve().
    const Eigen::VectorXd& deviation() const { return deviation_; }

private:
    void add_pin(const Kinematics& bodies, Eigen::Index row, const BodyPin& pin);
    void add_rotary(const Kinematics& bodies, Eigen::Index row, int body, double effort);
    void add_linear(const Kinematics& bodies, Eigen::Index row, int body, double effort);

    const PlanarModel& model_;
    double time_constant_;
    Eigen::VectorXd inverse_mass_, force_, accelerations_;
    Eigen::MatrixXd jacobian_;
    Eigen::VectorXd deviation_, rate_, bias_;  // D, D', and the part of D'' of speeds alone
};

}  // namespace cambrian
