#pragma once

// LU factors of the equations of the rows that hold: Gaussian elimination without pivoting, on
// lines padded to the vector width.

#include "core/assert.h"
#include "dynamics/model/lanes.h"

namespace cambrian {

inline constexpr int kMaxEquations = 128;

// One number for each equation, padded to the vector width.
using PerEquation = double[kMaxEquations + kLanes];

class RowFactors {
public:
    // Room for the lines of so many equations. Each has its coefficients and, in column `count`,
    // its right-hand side; the columns up to the stride are to be finite.
    void resize(int count) {
        CAMBRIAN_TICK_ASSERT(count >= 0 && count <= kMaxEquations, "equations have room");
        count_ = count;
        stride_ = round_up_to_lanes(count + 1);
    }
    int count() const { return count_; }
    int stride() const { return stride_; }
    double* line(int equation) { return lines_ + std::ptrdiff_t{equation} * stride_; }
    const double* line(int equation) const { return lines_ + std::ptrdiff_t{equation} * stride_; }

    // Factorises the lines and brings their right-hand sides along. False if a pivot is not above
    // the least it may be.
    bool factorize(const PerEquation& least_pivots);

    // The equation whose pivot was lost.
    int lost() const { return lost_; }

    // The solution of the lines' own equations.
    void substitute(PerEquation& solution) const;

    // Solutions for two other right-hand sides.
    void solve(const PerEquation (&sides)[2], PerEquation (&solutions)[2]) const;

private:
    int count_ = 0;
    int stride_ = 0;
    int lost_ = 0;
    // Below the diagonal the negative factors L, on it the inverse pivots, above it U.
    double lines_[kMaxEquations * (kMaxEquations + kLanes)];
};

}  // namespace cambrian
