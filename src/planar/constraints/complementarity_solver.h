#pragma once

// Complementarity solver for the rows of one state (planar/README.md 10). With y = bias + W p:
//     normal and limit rows:  p >= 0, y >= 0, p y = 0
//     friction rows:          |p| <= mu times the sum of their normals' p; y = 0 inside the cone,
//     y against p on its edge.
// Every row is in one state (off, active or sliding), and the states give p by one linear system.
// Rows that break their law change state, all at once for a few rounds, then one at a time
// (J. J. Judice, F. M. Pires, A block principal pivoting algorithm for large-scale strictly
// monotone linear complementarity problems, Comput. Oper. Res. 21 (1994)).

#include "core/assert.h"
#include "dynamics/simd.h"
#include "planar/constraints/rows.h"

namespace cambrian {

// LU factors of the equations of the active rows: Gaussian elimination without pivoting, on
// lines padded to the vector width.

inline constexpr int kMaxEquations = 188;

// One number for each equation, padded to the vector width.
using PerEquation = double[kMaxEquations + kLanes];

class RowFactors {
public:
    // Makes room for the lines of this many equations. A line has the coefficients and, in column
    // `count`, the right-hand side. The columns up to the stride must be finite.
    void resize(int count) {
        CAMBRIAN_TICK_ASSERT(count >= 0 && count <= kMaxEquations, "equations have room");
        count_ = count;
        stride_ = round_up_to_lanes(count + 1);
    }
    int count() const { return count_; }
    int stride() const { return stride_; }
    double* line(int equation) { return lines_ + std::ptrdiff_t{equation} * stride_; }
    const double* line(int equation) const { return lines_ + std::ptrdiff_t{equation} * stride_; }

    // Factorises the lines with their right-hand sides. Returns false if a pivot is not above its
    // least value.
    bool factorize(const PerEquation& least_pivots);

    // The equation with the failed pivot.
    int lost() const { return lost_; }

    // Solves for the right-hand sides of the lines.
    void substitute(PerEquation& solution) const;

    // Solves for two other right-hand sides.
    void solve(const PerEquation (&sides)[2], PerEquation (&solutions)[2]) const;

private:
    int count_ = 0;
    int stride_ = 0;
    int lost_ = 0;
    // The negative factors L are below the diagonal, the inverse pivots on it, and U above it.
    double lines_[kMaxEquations * (kMaxEquations + kLanes)];
};

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
