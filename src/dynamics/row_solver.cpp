#include "dynamics/row_solver.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr int kGuessSweeps = 2;
constexpr int kRounds = 6;
constexpr int kSweeps = 40;
constexpr double kSweepTolerance = 1e-3;  // m/s
constexpr double kRateTolerance = 1e-9;   // m/s
constexpr double kPivotTolerance = 1e-7;  // of the diagonal

double row_product(const RowSystem& rows, int row) {
    const double* line = rows.matrix + row * rows.stride;
    double sum = 0.0;
    for (int column = 0; column < rows.count; ++column)
        sum += line[column] * rows.impulse[column];
    return sum;
}

// One projected Gauss-Seidel sweep; the largest change of a row's rate, m/s.
double sweep(RowSystem& rows, const double* bias, double friction) {
    double change = 0.0;
    for (int row = 0; row < rows.count; ++row) {
        const double diagonal = rows.coupling(row, row);
        const double old = rows.impulse[row];
        double impulse = old - (bias[row] + row_product(rows, row)) / diagonal;
        if (rows.kind[row] == RowKind::kFriction) {
            const double cap = friction * rows.impulse[rows.normal[row]];
            impulse = std::fmin(std::fmax(impulse, -cap), cap);
        } else {
            impulse = std::fmax(impulse, 0.0);
        }
        rows.impulse[row] = impulse;
        change = std::fmax(change, std::fabs(impulse - old) * diagonal);
    }
    return change;
}

void iterate(RowSystem& rows, const double* bias, double friction) {
    for (int i = 0; i < kSweeps; ++i) {
        if (sweep(rows, bias, friction) < kSweepTolerance) return;
    }
}

}  // namespace

bool RowSolver::solve(RowSystem& rows, const double* bias, double friction) {
    for (int i = 0; i < kGuessSweeps; ++i)
        sweep(rows, bias, friction);
    double guess[kMaxRows];
    for (int row = 0; row < rows.count; ++row)
        guess[row] = rows.impulse[row];
    guess_states(rows, friction);
    if (solve_active(rows, bias, friction)) return true;
    for (int row = 0; row < rows.count; ++row)
        rows.impulse[row] = guess[row];
    iterate(rows, bias, friction);
    return false;
}

void RowSolver::iterate_from_zero(RowSystem& rows, const double* bias, double friction) {
    for (int row = 0; row < rows.count; ++row)
        rows.impulse[row] = 0.0;
    iterate(rows, bias, friction);
}

void RowSolver::guess_states(const RowSystem& rows, double friction) {
    for (int row = 0; row < rows.count; ++row) {
        const double impulse = rows.impulse[row];
        if (rows.kind[row] != RowKind::kFriction) {
            state_[row] = impulse > 0.0 ? State::kActive : State::kOff;
            continue;
        }
        const double cap = friction * rows.impulse[rows.normal[row]];
        if (cap <= 0.0)
            state_[row] = State::kOff;
        else if (std::fabs(impulse) < cap)
            state_[row] = State::kActive;
        else
            state_[row] = impulse > 0.0 ? State::kSlidePlus : State::kSlideMinus;
    }
}

bool RowSolver::solve_active(RowSystem& rows, const double* bias, double friction) {
    for (int round = 0; round < kRounds; ++round) {
        const int count = gather_active(rows, bias, friction);
        if (!eliminate(count)) return false;
        scatter_active(rows, friction, count);
        if (update_states(rows, bias, friction)) return true;
    }
    return false;
}

// Equations of the active rows; sliding friction is folded into its normal's column.
int RowSolver::gather_active(const RowSystem& rows, const double* bias, double friction) {
    int count = 0;
    for (int row = 0; row < rows.count; ++row) {
        if (state_[row] == State::kActive) active_[count++] = row;
    }
    for (int j = 0; j < count; ++j) {
        const int column = active_[j];
        const int mate = column + 1;
        double slide = 0.0;
        if (rows.kind[column] == RowKind::kNormal && mate < rows.count &&
            rows.kind[mate] == RowKind::kFriction) {
            if (state_[mate] == State::kSlidePlus) slide = friction;
            if (state_[mate] == State::kSlideMinus) slide = -friction;
        }
        for (int i = 0; i < count; ++i) {
            double entry = rows.coupling(active_[i], column);
            if (slide != 0.0) entry += slide * rows.coupling(active_[i], mate);
            system_[i * count + j] = entry;
        }
        right_[j] = -bias[column];
        pivot_scale_[j] = rows.coupling(column, column);
    }
    return count;
}

// Without pivoting: a lost pivot means contacts that wedge (Painleve), which the caller must not
// answer with a solution.
bool RowSolver::eliminate(int count) {
    for (int i = 0; i < count; ++i) {
        const double pivot = system_[i * count + i];
        if (!(pivot > kPivotTolerance * pivot_scale_[i])) return false;
        const double inverse = 1.0 / pivot;
        for (int k = i + 1; k < count; ++k) {
            const double factor = system_[k * count + i] * inverse;
            if (factor == 0.0) continue;
            for (int j = i + 1; j < count; ++j)
                system_[k * count + j] -= factor * system_[i * count + j];
            right_[k] -= factor * right_[i];
        }
    }
    for (int i = count - 1; i >= 0; --i) {
        double sum = right_[i];
        for (int j = i + 1; j < count; ++j)
            sum -= system_[i * count + j] * right_[j];
        right_[i] = sum / system_[i * count + i];
    }
    return true;
}

void RowSolver::scatter_active(RowSystem& rows, double friction, int count) const {
    for (int row = 0; row < rows.count; ++row)
        rows.impulse[row] = 0.0;
    for (int j = 0; j < count; ++j)
        rows.impulse[active_[j]] = right_[j];
    for (int row = 0; row < rows.count; ++row) {
        if (state_[row] == State::kSlidePlus)
            rows.impulse[row] = friction * rows.impulse[rows.normal[row]];
        if (state_[row] == State::kSlideMinus)
            rows.impulse[row] = -friction * rows.impulse[rows.normal[row]];
    }
}

// True if the solution obeys every row's law; otherwise moves the offending rows to the state
// their sign asks for.
bool RowSolver::update_states(const RowSystem& rows, const double* bias, double friction) {
    bool settled = true;
    const auto move = [&](int row, State state) {
        state_[row] = state;
        settled = false;
    };
    for (int row = 0; row < rows.count; ++row) {
        const double impulse = rows.impulse[row];
        const State state = state_[row];
        if (rows.kind[row] != RowKind::kFriction) {
            if (state == State::kActive && impulse < 0.0) move(row, State::kOff);
            if (state == State::kOff && bias[row] + row_product(rows, row) < -kRateTolerance)
                move(row, State::kActive);
            continue;
        }
        const bool loaded = state_[rows.normal[row]] == State::kActive;
        const double cap = friction * rows.impulse[rows.normal[row]];
        if (!loaded) {
            state_[row] = State::kOff;
        } else if (state == State::kOff) {
            move(row, State::kActive);
        } else if (state == State::kActive) {
            if (std::fabs(impulse) > cap)
                move(row, impulse > 0.0 ? State::kSlidePlus : State::kSlideMinus);
        } else {
            const double rate = bias[row] + row_product(rows, row);
            const double against = state == State::kSlidePlus ? rate : -rate;
            if (against > kRateTolerance) move(row, State::kActive);
        }
    }
    return settled;
}

}  // namespace cambrian
