#include "dynamics/row_solver.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr int kBlockRounds = 3;  // rounds in which all wrong rows change at once
constexpr int kRounds = 12;
constexpr int kSweeps = 40;
constexpr double kSweepTolerance = 1e-3;  // m/s
constexpr double kRateTolerance = 1e-9;   // m/s
constexpr double kPivotTolerance = 1e-7;  // of the diagonal

// Normal impulse that every friction row's cone stands on.
void sum_loads(const RowSystem& rows, double* load) {
    for (int row = 0; row < rows.count; ++row)
        load[row] = 0.0;
    for (int row = 0; row < rows.count; ++row) {
        if (rows.friction_of[row] >= 0) load[rows.friction_of[row]] += rows.impulse[row];
    }
}

// One projected Gauss-Seidel sweep; the largest change of a row's rate, m/s.
double sweep(RowSystem& rows, const double* bias, double friction, double* load) {
    double change = 0.0;
    for (int row = 0; row < rows.count; ++row) {
        const double diagonal = rows.coupling(row, row);
        const double old = rows.impulse[row];
        double impulse = old - (bias[row] + rows.product(row)) / diagonal;
        if (rows.kind[row] == RowKind::kFriction) {
            const double cap = friction * std::max(0.0, load[row]);
            impulse = std::clamp(impulse, -cap, cap);
        } else {
            impulse = std::max(impulse, 0.0);
            if (rows.friction_of[row] >= 0) load[rows.friction_of[row]] += impulse - old;
        }
        rows.impulse[row] = impulse;
        change = std::max(change, std::fabs(impulse - old) * diagonal);
    }
    return change;
}

void iterate(RowSystem& rows, const double* bias, double friction) {
    double load[kMaxRows];
    sum_loads(rows, load);
    for (int i = 0; i < kSweeps; ++i) {
        if (sweep(rows, bias, friction, load) < kSweepTolerance) break;
    }
    for (int row = 0; row < rows.count; ++row)
        rows.response[row] = rows.product(row);
}

}  // namespace

bool RowSolver::solve(RowSystem& rows, const double* bias, double friction) {
    for (int row = 0; row < rows.count; ++row)
        start_[row] = rows.impulse[row];
    sum_loads(rows, load_);
    guess_states(rows, bias, friction);
    if (settle(rows, bias, friction)) return true;
    for (int row = 0; row < rows.count; ++row)
        rows.impulse[row] = start_[row];
    iterate(rows, bias, friction);
    // Iteration mostly finds the right states, though not the impulses' last digits.
    for (int row = 0; row < rows.count; ++row)
        start_[row] = rows.impulse[row];
    sum_loads(rows, load_);
    read_states(rows, friction);
    if (settle(rows, bias, friction)) return true;
    for (int row = 0; row < rows.count; ++row)
        rows.impulse[row] = start_[row];
    for (int row = 0; row < rows.count; ++row)
        rows.response[row] = rows.product(row);
    return false;
}

void RowSolver::iterate_from_zero(RowSystem& rows, const double* bias, double friction) {
    for (int row = 0; row < rows.count; ++row)
        rows.impulse[row] = 0.0;
    iterate(rows, bias, friction);
}

// As the starting impulses have it; rows without one are active if nothing else keeps them open.
void RowSolver::guess_states(const RowSystem& rows, const double* bias, double friction) {
    for (int row = 0; row < rows.count; ++row) {
        const double impulse = rows.impulse[row];
        if (rows.kind[row] != RowKind::kFriction) {
            state_[row] = impulse > 0.0 || bias[row] < 0.0 ? State::kActive : State::kOff;
            continue;
        }
        const double cap = friction * load_[row];
        if (impulse == 0.0 || std::fabs(impulse) < cap * (1.0 - 1e-9))
            state_[row] = State::kActive;
        else
            state_[row] = impulse > 0.0 ? State::kSlidePlus : State::kSlideMinus;
    }
    for (int row = 0; row < rows.count; ++row) {
        if (rows.kind[row] == RowKind::kFriction) match_friction(rows, row, State::kActive);
    }
}

// As the impulses have it, which are near a solution.
void RowSolver::read_states(const RowSystem& rows, double friction) {
    constexpr double inside = 1.0 - 1e-6;  // share of the cone
    for (int row = 0; row < rows.count; ++row) {
        const double impulse = rows.impulse[row];
        if (rows.kind[row] != RowKind::kFriction)
            state_[row] = impulse > 0.0 ? State::kActive : State::kOff;
        else if (std::fabs(impulse) < inside * friction * load_[row])
            state_[row] = State::kActive;
        else
            state_[row] = impulse > 0.0 ? State::kSlidePlus : State::kSlideMinus;
    }
    for (int row = 0; row < rows.count; ++row) {
        if (rows.kind[row] == RowKind::kFriction) match_friction(rows, row, State::kActive);
    }
}

bool RowSolver::settle(RowSystem& rows, const double* bias, double friction) {
    for (int round = 0; round < kRounds; ++round) {
        const int count = gather_active(rows, bias, friction);
        if (!eliminate(count)) {
            if (!stop_slides(rows)) return false;
            continue;
        }
        scatter_active(rows, bias, friction, count);
        const int wrong = find_wrong(rows, bias, friction);
        if (wrong == 0) return true;
        const int first = round < kBlockRounds ? 0 : wrong - 1;
        for (int i = first; i < wrong; ++i)
            change_state(rows, bias, wrong_[i]);
    }
    return false;
}

// Equations of the active rows; sliding friction is folded into its normal's column.
int RowSolver::gather_active(const RowSystem& rows, const double* bias, double friction) {
    int count = 0;
    for (int row = 0; row < rows.count; ++row) {
        if (state_[row] == State::kActive) active_[count++] = row;
    }
    stride_ = round_up_to_lanes(count + 1);
    for (int j = count; j < stride_; ++j)
        active_[j] = 0;
    for (int i = 0; i < count; ++i) {
        double* line = line_of(i);
        const double* couplings = rows.line(active_[i]);
        for (int j = 0; j < stride_; j += kLanes)
            store_lanes(line + j, gather(couplings, active_ + j));
        line[count] = -bias[active_[i]];
        pivot_scale_[i] = line[i];
    }
    for (int j = 0; j < count; ++j) {
        const int mate = rows.friction_of[active_[j]];
        if (mate < 0 || state_[mate] < State::kSlidePlus) continue;
        const double slide = state_[mate] == State::kSlidePlus ? friction : -friction;
        for (int i = 0; i < count; ++i)
            line_of(i)[j] += slide * rows.coupling(active_[i], mate);
    }
    return count;
}

// Without pivoting: a lost pivot means contacts that slide and wedge (Painleve), which the caller
// must not answer with a solution. The solution is left in column `count`.
bool RowSolver::eliminate(int count) {
    for (int i = 0; i < count; ++i) {
        double* pivot_line = line_of(i);
        const double pivot = pivot_line[i];
        if (!(pivot > kPivotTolerance * pivot_scale_[i])) return false;
        const double inverse = 1.0 / pivot;
        const int from = (i + 1) / kLanes * kLanes;
        for (int k = i + 1; k < count; ++k) {
            double* line = line_of(k);
            const double factor = line[i] * inverse;
            for (int j = from; j < stride_; j += kLanes)
                store_lanes(line + j, load_lanes(line + j) - factor * load_lanes(pivot_line + j));
        }
        pivot_line[i] = inverse;
    }
    for (int i = count - 1; i >= 0; --i) {
        double* line = line_of(i);
        double sum = line[count];
        for (int j = i + 1; j < count; ++j)
            sum -= line[j] * line_of(j)[count];
        line[count] = sum * line[i];
    }
    return true;
}

// Lets everything stick that slides: rows that stick never lose a pivot. False if nothing slid.
bool RowSolver::stop_slides(const RowSystem& rows) {
    bool slid = false;
    for (int row = 0; row < rows.count; ++row) {
        if (state_[row] < State::kSlidePlus) continue;
        state_[row] = State::kActive;
        slid = true;
    }
    return slid;
}

void RowSolver::scatter_active(RowSystem& rows, const double* bias, double friction, int count) {
    for (int row = 0; row < rows.count; ++row)
        rows.impulse[row] = 0.0;
    for (int j = 0; j < count; ++j)
        rows.impulse[active_[j]] = line_of(j)[count];
    sum_loads(rows, load_);
    for (int row = 0; row < rows.count; ++row) {
        if (state_[row] == State::kSlidePlus) rows.impulse[row] = friction * load_[row];
        if (state_[row] == State::kSlideMinus) rows.impulse[row] = -friction * load_[row];
    }
    for (int row = 0; row < rows.count; ++row)
        rows.response[row] = state_[row] == State::kActive ? -bias[row] : rows.product(row);
}

// Lists the rows whose impulse or rate breaks their law.
int RowSolver::find_wrong(const RowSystem& rows, const double* bias, double friction) {
    int count = 0;
    for (int row = 0; row < rows.count; ++row) {
        wanted_[row] = wanted_state(rows, row, bias[row] + rows.response[row], friction);
        if (wanted_[row] != state_[row]) wrong_[count++] = row;
    }
    return count;
}

RowSolver::State RowSolver::wanted_state(const RowSystem& rows, int row, double rate,
                                         double friction) const {
    const double impulse = rows.impulse[row];
    const State state = state_[row];
    if (rows.kind[row] != RowKind::kFriction) {
        if (state == State::kActive) return impulse < 0.0 ? State::kOff : State::kActive;
        return rate < -kRateTolerance ? State::kActive : State::kOff;
    }
    switch (state) {
        case State::kOff:
            return State::kOff;
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

// Friction that comes back slides: if it stuck, a normal that sticking pulls off would come and go.
void RowSolver::change_state(const RowSystem& rows, const double* bias, int row) {
    state_[row] = wanted_[row];
    const int friction_row = rows.kind[row] == RowKind::kFriction ? row : rows.friction_of[row];
    if (friction_row < 0) return;
    const double rate = bias[friction_row] + rows.response[friction_row];
    match_friction(rows, friction_row, rate < 0.0 ? State::kSlidePlus : State::kSlideMinus);
}

// Friction is off exactly while none of its normals is active.
void RowSolver::match_friction(const RowSystem& rows, int friction_row, State awakened) {
    bool loaded = false;
    for (int row = 0; row < rows.count && !loaded; ++row)
        loaded = rows.friction_of[row] == friction_row && state_[row] == State::kActive;
    if (!loaded)
        state_[friction_row] = State::kOff;
    else if (state_[friction_row] == State::kOff)
        state_[friction_row] = awakened;
}

}  // namespace cambrian
