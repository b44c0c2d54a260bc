#pragma once

// Loop-closure joints (dynamics/README.md 17). Their impulses follow from a dense system with two
// rows per joint, the Schur complement of the trees. It is solved by least squares, so that
// redundant joints are allowed.

#include "dynamics/articulated/articulated_body.h"

#include <Eigen/QR>

#include <vector>

namespace cambrian {

class LoopClosure {
public:
    // The kinematics and the factors belong to one state.
    LoopClosure(const PlanarModel& model, const Kinematics& kinematics, const Factors& factors);

    // Responses of the trees to unit impulses, two for each loop closure: along x, then along y.
    const std::vector<BodyResponse>& unit_responses() const { return units_; }

    // Impulses that give the points of each loop closure these relative rates, by least squares.
    Eigen::MatrixXd impulses(const Eigen::MatrixXd& rates) const {
        return decomposition_.solve(rates);
    }

    // Turn accelerations or jumps of the trees alone into those with closed loops.
    void close_accelerations(BodyResponse& accelerations) const;
    void close_jumps(BodyResponse& jumps) const;

    // Removes small gaps and relative rates from the motion by the least change in the metric of
    // the masses. The change of speeds never adds kinetic energy.
    void close_drift(Motion& motion) const;

private:
    using Rates = Eigen::VectorXd;  // two for each loop closure

    Rates rates_of(const PerBody& x, const PerBody& y, const PerBody& spin) const;
    void add_response(const Rates& rates, BodyResponse& response) const;

    const PlanarModel& model_;
    const Kinematics& kinematics_;
    std::vector<BodyResponse> units_;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition_;
};

// Turns the accelerations of the trees alone into those with closed loops.
void close_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                         const Factors& factors, BodyResponse& accelerations);

// Does what solve_impulse does, with closed loops.
void solve_closed_impulse(const PlanarModel& model, const Kinematics& kinematics,
                          const Factors& factors, const Loads& impulses, BodyResponse& response);

}  // namespace cambrian
