#pragma once

// Complementarity solver for the rows of one moment (physics.md 7.5). With y = bias + W p:
//     normal and limit rows:  p >= 0, y >= 0, p y = 0
//     friction rows:          |p| <= mu times the sum of their normals' p, y = 0 inside, y against
//     p on the cone's edge.
// Every row is in one state, and the states give p by one linear system. Wrong rows change state
// all at once for a few rounds, then one at a time (J. J. Judice, F. M. Pires, A block principal
// pivoting algorithm for large-scale strictly monotone linear complementarity problems, Comput.
// Oper. Res. 21 (1994)).

#include "dynamics/rows.h"

namespace cambrian {

class RowSolver {
public:
    // Starts from the impulses in rows and leaves the solution there, with its response. False if
    // the states did not settle and plain iteration had to do.
    bool solve(RowSystem& rows, const double* bias, double friction);

    // Projected Gauss-Seidel from zero impulses; friction 0 always has a solution.
    void iterate_from_zero(RowSystem& rows, const double* bias, double friction);

private:
    enum class State : std::uint8_t { kOff, kActive, kSlidePlus, kSlideMinus };

    void guess_states(const RowSystem& rows, const double* bias, double friction);
    void read_states(const RowSystem& rows, double friction);
    bool settle(RowSystem& rows, const double* bias, double friction);
    int gather_active(const RowSystem& rows, const double* bias, double friction);
    bool eliminate(int count);
    bool stop_slides(const RowSystem& rows);
    void scatter_active(RowSystem& rows, const double* bias, double friction, int count);
    int find_wrong(const RowSystem& rows, const double* bias, double friction);
    State wanted_state(const RowSystem& rows, int row, double rate, double friction) const;
    void change_state(const RowSystem& rows, const double* bias, int row);
    void match_friction(const RowSystem& rows, int friction_row, State awakened);

    double* line_of(int row) { return system_ + std::ptrdiff_t{row} * stride_; }

    State state_[kMaxRows];
    State wanted_[kMaxRows];
    int wrong_[kMaxRows];            // rows whose wanted state is another
    double load_[kMaxRows];          // normal impulse of every friction row
    int active_[kMaxRows + kLanes];  // filled up with 0 to the stride
    double pivot_scale_[kMaxRows];
    int stride_ = 0;                                 // of the system
    double system_[kMaxRows * (kMaxRows + kLanes)];  // right-hand side in column `count`
    double start_[kMaxRows];                         // impulses to iterate from
};

}  // namespace cambrian
