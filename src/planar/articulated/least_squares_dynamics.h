#pragma once

// The equation of constraint forces in three dependent coordinates for each body, solved by dense
// least squares (planar/README.md 18). It closes joints that have come apart. It is slow, and the
// reference for the articulated body algorithm.

#include "planar/articulated/articulated_body.h"

#include <Eigen/Core>

namespace cambrian {

class LeastSquaresDynamics {
public:
    // `time_constant`, in s, is the time in which gaps of joints close.
    LeastSquaresDynamics(const PlanarModel& model, double time_constant);

    // Returns the accelerations (x, y, spin of every body). Of the kinematics it reads only
    // positions, angles and velocities.
    const Eigen::VectorXd& solve(const Kinematics& bodies, const Loads& loads);

    // Deviations of the joints after solve(), in m and rad: two rows for each joint.
    const Eigen::VectorXd& deviation() const { return deviation_; }

private:
    void add_revolute(const Kinematics& bodies, Eigen::Index row, int body, double effort);
    void add_prismatic(const Kinematics& bodies, Eigen::Index row, int body, double effort);

    const PlanarModel& model_;
    double time_constant_;
    Eigen::VectorXd inverse_mass_, force_, accelerations_;
    Eigen::MatrixXd jacobian_;
    Eigen::VectorXd deviation_, rate_, bias_;  // D, D', and the part of D'' of speeds alone
};

}  // namespace cambrian
