#pragma once

// Closed loops on top of the elimination of trees: the closing pins answer whatever the trees alone
// would do. Their impulses follow from a dense system as large as the pins are many (the Schur
// complement of the trees), solved in the least-squares sense, so that redundant pins do no harm.

#include "dynamics/articulated/elimination.h"

#include <Eigen/QR>

#include <vector>

namespace cambrian {

class LoopClosure {
public:
    // At one moment: its kinematics, and the factors of its trees.
    LoopClosure(const PlanarModel& model, const Kinematics& kinematics, const Factors& factors);

    // Responses of the trees to a unit impulse in every pin, two a pin: along x, then along y.
    const std::vector<BodyResponse>& unit_responses() const { return units_; }

    // Impulses that give the pins' points these rates against each other, as well as possible.
    Eigen::MatrixXd impulses(const Eigen::MatrixXd& rates) const {
        return decomposition_.solve(rates);
    }

    // Accelerations or jumps of the trees become those with the pins.
    void close_accelerations(BodyResponse& accelerations) const;
    void close_jumps(BodyResponse& jumps) const;

    // Takes small gaps and rates of the pins from the moment's motion by the least change in the
    // metric of the masses; that of speeds can only take kinetic energy.
    void close_drift(Motion& motion) const;

private:
    using Rates = Eigen::VectorXd;  // two a pin

    Rates rates_of(const PerBody& x, const PerBody& y, const PerBody& spin) const;
    void add_response(const Rates& rates, BodyResponse& response) const;

    const PlanarModel& model_;
    const Kinematics& kinematics_;
    std::vector<BodyResponse> units_;
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition_;
};

// From the accelerations of the trees alone to those of closed loops.
void close_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                         const Factors& factors, BodyResponse& accelerations);

// As solve_impulse, loops kept closed.
void solve_closed_impulse(const PlanarModel& model, const Kinematics& kinematics,
                          const Factors& factors, const Loads& impulses, BodyResponse& response);

}  // namespace cambrian
