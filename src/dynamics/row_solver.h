#pragma once

// Complementarity solver for the rows of one moment (physics.md 7.5). With y = bias + W p:
//     normal and limit rows:  p >= 0, y >= 0, p y = 0
//     friction rows:          |p| <= mu p_n, y = 0 inside, y against p on the cone's edge.

#include "dynamics/rows.h"

namespace cambrian {

class RowSolver {
public:
    // Starts from the impulses in rows and leaves the solution there. False if the active set did
    // not settle and plain iteration had to do.
    bool solve(RowSystem& rows, const double* bias, double friction);

    // Projected Gauss-Seidel from zero impulses; friction 0 always has a solution.
    void iterate_from_zero(RowSystem& rows, const double* bias, double friction);

private:
    enum class State : std::uint8_t { kOff, kActive, kSlidePlus, kSlideMinus };

    void guess_states(const RowSystem& rows, double friction);
    bool solve_active(RowSystem& rows, const double* bias, double friction);
    int gather_active(const RowSystem& rows, const double* bias, double friction);
    bool eliminate(int count);
    void scatter_active(RowSystem& rows, double friction, int count) const;
    bool update_states(const RowSystem& rows, const double* bias, double friction);

    State state_[kMaxRows];
    int active_[kMaxRows];
    double right_[kMaxRows];
    double pivot_scale_[kMaxRows];
    double system_[kMaxRows * kMaxRows];
};

}  // namespace cambrian
