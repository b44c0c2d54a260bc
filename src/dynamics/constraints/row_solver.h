#pragma once

// Complementarity solver for the rows of one moment (physics.md 7.5). With y = bias + W p:
//     normal and limit rows:  p >= 0, y >= 0, p y = 0
//     friction rows:          |p| <= mu times the sum of their normals' p, y = 0 inside, y against
//     p on the cone's edge.
// Every row is in one state, and the states give p by one linear system. Wrong rows change state
// all at once for a few rounds, then one at a time (J. J. Judice, F. M. Pires, A block principal
// pivoting algorithm for large-scale strictly monotone linear complementarity problems, Comput.
// Oper. Res. 21 (1994)).

#include "dynamics/constraints/row_factors.h"
#include "dynamics/constraints/rows.h"

namespace cambrian {

// Two changes of rates and the impulses that answer them, by row.
struct RowChanges {
    double rates[2][kMaxRows];
    double impulses[2][kMaxRows];
};

class RowSolver {
public:
    // Starts from the impulses in rows and leaves the solution there, with its response. False if
    // the states did not settle and plain iteration had to do.
    bool solve(RowSystem& rows, const double* bias, double friction);

    // Projected Gauss-Seidel from zero impulses; friction 0 always has a solution.
    void iterate_from_zero(RowSystem& rows, const double* bias, double friction);

    // Impulses that undo changes of the rates of the rows that hold in the last solution: those
    // inside their bounds, sliding ones along with their normals. 0 where that has no safe answer.
    void absorb(const RowSystem& rows, double friction, RowChanges& changes);

private:
    enum class State : std::uint8_t { kOff, kActive, kSlidePlus, kSlideMinus };

    void find_rates(const RowSystem& rows, const double* bias);
    void sweep(RowSystem& rows, double friction, int sweeps);
    template <int kFixed>
    double sweep_once(RowSystem& rows, double friction);
    void guess_states(const RowSystem& rows, const double* bias, double friction);
    void read_states(const RowSystem& rows, const double* bias, double friction);
    static State sticking_or_sliding(double impulse, double cap);
    bool settle(RowSystem& rows, const double* bias, double friction);
    bool factorize(const RowSystem& rows, const double* bias, double friction);
    bool stop_slides(const RowSystem& rows);
    void scatter_solution(RowSystem& rows, const double* bias, double friction);
    int find_wrong(const RowSystem& rows, const double* bias, double friction);
    State wanted_normal(const RowSystem& rows, const double* bias, int row) const;
    State wanted_friction(const RowSystem& rows, const double* bias, int row,
                          double friction) const;
    void match_frictions(const RowSystem& rows, const double* bias);

    State state_[kMaxRows];
    State wanted_[kMaxRows];
    int wrong_[kMaxRows];            // rows whose wanted state is another
    double load_[kMaxRows];          // normal impulse of every friction row
    double rates_[kMaxRows];         // after the impulses that iteration has reached
    int active_[kMaxRows + kLanes];  // filled up with 0 to the stride
    int sliding_[kMaxRows];
    int sliding_count_ = 0;
    PerEquation least_pivot_;
    RowFactors factors_;  // of the active rows
    bool are_factors_valid_ = false;
    PerEquation solution_;
    double start_[kMaxRows];  // impulses to iterate from
};

}  // namespace cambrian
