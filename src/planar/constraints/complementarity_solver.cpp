#include "planar/constraints/complementarity_solver.h"

#include "core/assert.h"
#include "dynamics/simd.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cambrian {
namespace {

constexpr int kGuessSweeps = 2;  // before the states are guessed
constexpr int kBlockRounds = 5;  // rounds in which all wrong rows change at once
constexpr int kRounds = 12;
constexpr int kSweeps = 40;
constexpr double kSweepTolerance = 1e-3;  // m/s
constexpr double kRateTolerance = 1e-9;   // m/s
constexpr double kConeShare = 1e-9;       // of a cone's width; a nearer impulse is on its edge
constexpr double kPivotTolerance = 1e-7;  // of the diagonal
constexpr double kNoCap = std::numeric_limits<double>::infinity();  // N s or N m s

// Sums the normal impulses that bound each friction row.
void sum_loads(const ConstraintSystem& rows, double* load) {
    for (int row = 0; row < rows.stride; row += kLanes)
        store_lanes(load + row, Simd4d{});
    for (int row = 0; row < rows.count; ++row) {
        if (rows[row].friction_of >= 0) load[rows[row].friction_of] += rows.impulse[row];
    }
}

// Adds the effect of an impulse to all rates. The matrix is symmetric, so a row's line is its
// column.
template <int kFixed>
CAMBRIAN_INLINE void add_column(const ConstraintSystem& rows, int row, double impulse,
                                double* rates) {
    const double* line = rows.line(row);
    for (int b = 0; b < block_count<kFixed>(rows.stride / kLanes); ++b)
        store_lanes(rates + b * kLanes,
                    load_lanes(rates + b * kLanes) + impulse * load_lanes(line + b * kLanes));
}

}  // namespace

bool ComplementaritySolver::solve(ConstraintSystem& rows, const double* bias, double friction) {
    CAMBRIAN_TICK_ASSERT(rows.count >= 0 && rows.count <= kMaxRows, "rows have room");
    CAMBRIAN_TICK_ASSERT(friction >= 0.0, "friction is not negative");
    find_rates(rows, bias);
    sweep(rows, friction, kGuessSweeps);
    guess_states(rows, bias, friction);
    for (int row = 0; row < rows.count; ++row)
        start_[row] = rows.impulse[row];
    if (settle(rows, bias, friction)) return true;
    for (int row = 0; row < rows.count; ++row)
        rows.impulse[row] = start_[row];
    find_rates(rows, bias);
    sweep(rows, friction, kSweeps);
    // The iteration mostly finds the right states, but not accurate impulses.
    for (int row = 0; row < rows.count; ++row)
        start_[row] = rows.impulse[row];
    read_states(rows, bias, friction);
    if (settle(rows, bias, friction)) return true;
    for (int row = 0; row < rows.count; ++row) {
        rows.impulse[row] = start_[row];
        rows.response[row] = rates_[row] - bias[row];
    }
    return false;
}

void ComplementaritySolver::iterate_from_zero(ConstraintSystem& rows, const double* bias,
                                              double friction) {
    CAMBRIAN_TICK_ASSERT(friction >= 0.0, "friction is not negative");
    for (int row = 0; row < rows.count; ++row)
        rows.impulse[row] = 0.0;
    find_rates(rows, bias);
    sweep(rows, friction, kSweeps);
    for (int row = 0; row < rows.count; ++row)
        rows.response[row] = rates_[row] - bias[row];
    are_factors_valid_ = false;
}

bool ComplementaritySolver::absorb(const ConstraintSystem& rows, double friction,
                                   RowChanges& changes) {
    for (auto& impulses : changes.impulses) {
        for (int row = 0; row < rows.count; ++row)
            impulses[row] = 0.0;
    }
    if (!are_factors_valid_) {
        read_states(rows, changes.rates[0], friction);
        if (!factorize(rows, changes.rates[0], friction)) return false;
    }
    if (factors_.count() == 0) return false;
    CAMBRIAN_TICK_ASSERT(factors_.count() <= rows.count, "equations of these rows");
    PerEquation sides[2];
    PerEquation solutions[2];
    for (int s = 0; s < 2; ++s) {
        for (int i = 0; i < factors_.count(); ++i)
            sides[s][i] = -changes.rates[s][active_[i]];
    }
    factors_.solve(sides, solutions);
    for (int s = 0; s < 2; ++s) {
        double* impulses = changes.impulses[s];
        for (int i = 0; i < factors_.count(); ++i) {
            const int row = active_[i];
            CAMBRIAN_TICK_ASSERT(row >= 0 && row < rows.count, "a row that holds");
            const int mate = rows[row].friction_of;
            impulses[row] += solutions[s][i];
            if (mate < 0) continue;
            if (state_[mate] == State::kSlidePlus) impulses[mate] += friction * solutions[s][i];
            if (state_[mate] == State::kSlideMinus) impulses[mate] -= friction * solutions[s][i];
        }
    }
    return true;
}

void ComplementaritySolver::find_rates(const ConstraintSystem& rows, const double* bias) {
    for (int row = 0; row < rows.count; ++row)
        rates_[row] = bias[row];
    for (int row = rows.count; row < rows.stride; ++row)
        rates_[row] = 0.0;
    with_fixed_blocks(rows.stride / kLanes, [&](auto fixed) {
        for (int row = 0; row < rows.count; ++row) {
            if (rows.impulse[row] != 0.0) add_column<fixed()>(rows, row, rows.impulse[row], rates_);
        }
    });
    sum_loads(rows, load_);
}

// Runs projected Gauss-Seidel sweeps until the rates hardly change.
void ComplementaritySolver::sweep(ConstraintSystem& rows, double friction, int sweeps) {
    with_fixed_blocks(rows.stride / kLanes, [&](auto fixed) {
        double change = kSweepTolerance;
        for (int i = 0; i < sweeps && change >= kSweepTolerance; ++i)
            change = sweep_once<fixed()>(rows, friction);
    });
}

// Returns the largest change of a row's rate, m/s.
template <int kFixed>
double ComplementaritySolver::sweep_once(ConstraintSystem& rows, double friction) {
    double largest = 0.0;
    for (int r = 0; r < rows.count; ++r) {
        const Row& row = rows[r];
        const double diagonal = rows.coupling(r, r);
        const double old = rows.impulse[r];
        double impulse = old - rates_[r] / diagonal;
        const bool rubs = row.kind == RowKind::kFriction;
        const double cap = friction * std::max(0.0, load_[r]);
        impulse = std::max(impulse, rubs ? -cap : 0.0);
        impulse = std::min(impulse, rubs ? cap : kNoCap);
        const double change = impulse - old;
        if (change == 0.0) continue;
        if (row.friction_of >= 0) load_[row.friction_of] += change;
        rows.impulse[r] = impulse;
        add_column<kFixed>(rows, r, change, rates_);
        largest = std::max(largest, std::fabs(change) * diagonal);
    }
    return largest;
}

// Sets the states that belong to the impulses.
void ComplementaritySolver::read_states(const ConstraintSystem& rows, const double* bias,
                                        double friction) {
    sum_loads(rows, load_);
    for (int row = 0; row < rows.count; ++row) {
        const double impulse = rows.impulse[row];
        if (rows[row].kind == RowKind::kFriction)
            state_[row] = sticking_or_sliding(impulse, friction * load_[row]);
        else
            state_[row] = impulse > 0.0 ? State::kActive : State::kOff;
    }
    match_frictions(rows, bias);
}

// Sets the states that belong to the impulses of the sweeps; rows that still close are active too.
void ComplementaritySolver::guess_states(const ConstraintSystem& rows, const double* bias,
                                         double friction) {
    for (int row = 0; row < rows.count; ++row) {
        const double impulse = rows.impulse[row];
        if (rows[row].kind == RowKind::kFriction)
            state_[row] = sticking_or_sliding(impulse, friction * load_[row]);
        else
            state_[row] = impulse > 0.0 || rates_[row] < 0.0 ? State::kActive : State::kOff;
    }
    match_frictions(rows, bias);
}

ComplementaritySolver::State ComplementaritySolver::sticking_or_sliding(double impulse,
                                                                        double cap) {
    if (impulse == 0.0 || std::fabs(impulse) < cap * (1.0 - kConeShare)) return State::kActive;
    return impulse > 0.0 ? State::kSlidePlus : State::kSlideMinus;
}

bool ComplementaritySolver::settle(ConstraintSystem& rows, const double* bias, double friction) {
    are_factors_valid_ = false;
    for (int round = 0; round < kRounds; ++round) {
        if (!factorize(rows, bias, friction)) {
            if (!stop_slides(rows)) return false;
            continue;
        }
        scatter_solution(rows, bias, friction);
        const int wrong = find_wrong(rows, bias, friction);
        if (wrong == 0) {
            are_factors_valid_ = true;
            return true;
        }
        for (int i = round < kBlockRounds ? 0 : wrong - 1; i < wrong; ++i)
            state_[wrong_[i]] = wanted_[wrong_[i]];
        match_frictions(rows, bias);
    }
    return false;
}

// Builds and factorises the equations of the active rows, with sliding friction in the columns of
// its normals. Returns false if a pivot fails: contacts that slide and wedge (Painleve), for which
// the equations have no valid solution.
bool ComplementaritySolver::factorize(const ConstraintSystem& rows, const double* bias,
                                      double friction) {
    int count = 0;
    sliding_count_ = 0;
    for (int row = 0; row < rows.count; ++row) {
        if (state_[row] == State::kActive) active_[count++] = row;
        if (state_[row] >= State::kSlidePlus) sliding_[sliding_count_++] = row;
    }
    CAMBRIAN_TICK_ASSERT(count <= kMaxEquations, "equations have room");
    CAMBRIAN_TICK_ASSERT(count + sliding_count_ <= rows.count, "a row is in one state");
    factors_.resize(count);
    const int stride = factors_.stride();
    for (int j = count; j < stride; ++j)
        active_[j] = 0;
    for (int i = 0; i < count; ++i) {
        double* line = factors_.line(i);
        const double* couplings = rows.line(active_[i]);
        for (int j = 0; j < stride; j += kLanes)
            store_lanes(line + j, gather(couplings, active_ + j));
        line[count] = -bias[active_[i]];
        least_pivot_[i] = kPivotTolerance * line[i];
    }
    for (int j = 0; sliding_count_ > 0 && j < count; ++j) {
        const int mate = rows[active_[j]].friction_of;
        if (mate < 0 || state_[mate] < State::kSlidePlus) continue;
        CAMBRIAN_TICK_ASSERT(rows[mate].kind == RowKind::kFriction, "what slides is friction");
        const double slide = state_[mate] == State::kSlidePlus ? friction : -friction;
        const double* couplings = rows.line(mate);
        for (int i = 0; i < count; ++i)
            factors_.line(i)[j] += slide * couplings[active_[i]];
    }
    return factors_.factorize(least_pivot_);
}

// Sticking rows never cause a failed pivot. The friction of the contact with the failed pivot
// sticks from now on, or all friction if that one did not slide. Returns false if nothing slid.
bool ComplementaritySolver::stop_slides(const ConstraintSystem& rows) {
    CAMBRIAN_TICK_ASSERT(factors_.lost() >= 0 && factors_.lost() < factors_.count(),
                         "a pivot of the equations");
    const int mate = rows[active_[factors_.lost()]].friction_of;
    if (mate >= 0 && state_[mate] >= State::kSlidePlus) {
        state_[mate] = State::kActive;
        return true;
    }
    for (int i = 0; i < sliding_count_; ++i)
        state_[sliding_[i]] = State::kActive;
    return sliding_count_ > 0;
}

void ComplementaritySolver::scatter_solution(ConstraintSystem& rows, const double* bias,
                                             double friction) {
    factors_.substitute(solution_);
    for (int row = 0; row < rows.stride; row += kLanes) {
        store_lanes(rows.impulse + row, Simd4d{});
        store_lanes(load_ + row, Simd4d{});
    }
    for (int i = 0; i < factors_.count(); ++i) {
        const int row = active_[i];
        rows.impulse[row] = solution_[i];
        rows.response[row] = -bias[row];
        if (rows[row].friction_of >= 0) load_[rows[row].friction_of] += solution_[i];
    }
    for (int i = 0; i < sliding_count_; ++i) {
        const int row = sliding_[i];
        CAMBRIAN_TICK_ASSERT(rows[row].kind == RowKind::kFriction, "what slides is friction");
        const double impulse = friction * load_[row];
        rows.impulse[row] = state_[row] == State::kSlidePlus ? impulse : -impulse;
    }
    for (int i = 0; i < sliding_count_; ++i)
        rows.response[sliding_[i]] = rows.product(sliding_[i]);
}

// Lists the rows whose impulse or rate breaks their law; returns their number.
int ComplementaritySolver::find_wrong(const ConstraintSystem& rows, const double* bias,
                                      double friction) {
    int count = 0;
    for (int row = 0; row < rows.count; ++row) {
        wanted_[row] = rows[row].kind == RowKind::kFriction
                           ? wanted_friction(rows, bias, row, friction)
                           : wanted_normal(rows, bias, row);
        if (wanted_[row] != state_[row]) wrong_[count++] = row;
    }
    return count;
}

ComplementaritySolver::State ComplementaritySolver::wanted_normal(const ConstraintSystem& rows,
                                                                  const double* bias,
                                                                  int row) const {
    if (state_[row] == State::kActive)
        return rows.impulse[row] < 0.0 ? State::kOff : State::kActive;
    return bias[row] + rows.product(row) < -kRateTolerance ? State::kActive : State::kOff;
}

ComplementaritySolver::State ComplementaritySolver::wanted_friction(const ConstraintSystem& rows,
                                                                    const double* bias, int row,
                                                                    double friction) const {
    const double impulse = rows.impulse[row];
    const double rate = bias[row] + rows.response[row];
    switch (state_[row]) {
        case State::kOff:
            break;
        case State::kActive:
            if (std::fabs(impulse) <= friction * load_[row]) return State::kActive;
            return impulse > 0.0 ? State::kSlidePlus : State::kSlideMinus;
        case State::kSlidePlus:
            return rate > kRateTolerance ? State::kActive : State::kSlidePlus;
        case State::kSlideMinus:
            return rate < -kRateTolerance ? State::kActive : State::kSlideMinus;
    }
    return State::kOff;
}

// Friction is off exactly while none of its normals is active. Friction that becomes active slides
// first: if it stuck, a normal that sticking pulls off would alternate between on and off.
void ComplementaritySolver::match_frictions(const ConstraintSystem& rows, const double* bias) {
    bool is_loaded[kMaxRows];
    for (int row = 0; row < rows.count; ++row)
        is_loaded[row] = false;
    for (int row = 0; row < rows.count; ++row) {
        CAMBRIAN_TICK_ASSERT(rows[row].friction_of < rows.count, "friction is a row");
        if (rows[row].friction_of >= 0 && state_[row] == State::kActive)
            is_loaded[rows[row].friction_of] = true;
    }
    for (int row = 0; row < rows.count; ++row) {
        if (rows[row].kind != RowKind::kFriction) continue;
        if (!is_loaded[row]) {
            state_[row] = State::kOff;
        } else if (state_[row] == State::kOff) {
            const double rate = bias[row] + rows.product(row);
            state_[row] = rate < 0.0 ? State::kSlidePlus : State::kSlideMinus;
        }
    }
}

}  // namespace cambrian
