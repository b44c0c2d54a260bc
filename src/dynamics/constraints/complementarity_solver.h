#pragma once

// Complementarity solver for the rows of one state (dynamics/README.md 10). With y = bias + W p:
//     normal and limit rows:  p >= 0, y >= 0, p y = 0
//     friction rows:          |p| <= mu times the sum of their normals' p; y = 0 inside the cone,
//     y against p on its edge.
// Every row is in one state (off, active or sliding), and the states give p by one linear system.
// Rows that break their law change state, all at once for a few rounds, then one at a time
// (J. J. Judice, F. M. Pires, A block principal pivoting algorithm for large-scale strictly
// monotone linear complementarity problems, Comput. Oper. Res. 21 (1994)).

#include "dynamics/constraints/row_factors.h"
#include "dynamics/constraints/rows.h"

namespace cambrian {

// Two sets of changes of rates and the impulses that undo them, by row.
struct RowChanges {
    double rates[2][kMaxRows];
    double impulses[2][kMaxRows];
};

class ComplementaritySolver {
public:
    // Starts from the impulses in rows and replaces them by the solution and its response. Returns
    // false if the states did not settle and the result is that of the iteration.
    bool solve(ConstraintSystem& rows, const double* bias, double friction);

    // Runs projected Gauss-Seidel from zero impulses. With friction 0 there is always a solution.
    void iterate_from_zero(ConstraintSystem& rows, const double* bias, double friction);

    // Computes impulses that undo changes of the rates of the active rows of the last solution;
    // sliding friction follows its normal. They are 0 where the equations are singular.
    // Returns false if all are 0.
    bool absorb(const ConstraintSystem& rows, double friction, RowChanges& changes);

private:
    enum class State : std::uint8_t { kOff, kActive, kSlidePlus, kSlideMinus };

    void find_rates(const ConstraintSystem& rows, const double* bias);
    void sweep(ConstraintSystem& rows, double friction, int sweeps);
    template <int kFixed>
    double sweep_once(ConstraintSystem& rows, double friction);
    void guess_states(const ConstraintSystem& rows, const double* bias, double friction);
    void read_states(const ConstraintSystem& rows, const double* bias, double friction);
    static State sticking_or_sliding(double impulse, double cap);
    bool settle(ConstraintSystem& rows, const double* bias, double friction);
    bool factorize(const ConstraintSystem& rows, const double* bias, double friction);
    bool stop_slides(const ConstraintSystem& rows);
    void scatter_solution(ConstraintSystem& rows, const double* bias, double friction);
    int find_wrong(const ConstraintSystem& rows, const double* bias, double friction);
    State wanted_normal(const ConstraintSystem& rows, const double* bias, int row) const;
    State wanted_friction(const ConstraintSystem& rows, const double* bias, int row,
                          double friction) const;
    void match_frictions(const ConstraintSystem& rows, const double* bias);

    State state_[kMaxRows];
    State wanted_[kMaxRows];
    int wrong_[kMaxRows];            // rows that must change state
    double load_[kMaxRows];          // sum of the normal impulses of every friction row
    double rates_[kMaxRows];         // under the impulses of the iteration
    int active_[kMaxRows + kLanes];  // filled up with 0 to the stride
    int sliding_[kMaxRows];
    int sliding_count_ = 0;
    PerEquation least_pivot_;
    RowFactors factors_;  // of the active rows
    bool are_factors_valid_ = false;
    PerEquation solution_;
    double start_[kMaxRows];  // impulses from which the iteration starts
};

}  // namespace cambrian
