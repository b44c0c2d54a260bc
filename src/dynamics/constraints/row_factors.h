#pragma once

// LU factors of the equations of the active rows: Gaussian elimination without pivoting, on
// lines padded to the vector width.

#include "core/assert.h"
#include "dynamics/model/simd.h"

namespace cambrian {

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

}  // namespace cambrian
