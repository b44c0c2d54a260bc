// Rows are active or off. Rows that break their law change state, for five rounds all at once, then
// the first of them alone, which ends for every positive definite matrix (J. J. Judice, F. M.
// Pires, Comput. Oper. Res. 21, 1994).

#include "spatial/limits.h"

#include <algorithm>
#include <cmath>

namespace cambrian::spatial {
namespace {

constexpr double kReach = 1e-3;             // rad or m; of stops that count as touched
constexpr double kReachSteps = 1.5;         // steps in which a closing joint may reach its stop
constexpr double kRegularization = 1e-7;    // share of the diagonal
constexpr double kBackRate = 1.0;           // rad/s or m/s; fastest way back from beyond a stop
constexpr double kBackShare = 0.1 * 120.0;  // 1/s
constexpr double kUsualRate = 120.0;        // 1/s
constexpr int kJointRounds = 5;
constexpr int kMostRounds = 400;

// Returns what is added to the free rate at the end of a step before it must not be negative.
double slack_of(const LimitRow& row, double h) {
    if (row.gap < 0.0) {
        const double back =
            std::min(kBackRate, -kBackShare * row.gap) * std::min(1.0, kUsualRate * h);
        return std::max(-back, row.rate - 2.0 * back);
    }
    if (row.rate <= 0.0) return std::max(0.0, row.gap / h + 0.5 * row.rate);
    return std::max(0.0, 2.0 * row.gap / h + row.rate);
}

template <class Take>
void visit_stops(const Model& model, const Motion& motion, Take&& take) {
    for (int d = 0; d < model.degree_count; ++d) {
        const Degree& degree = model.degrees[d];
        const double position = motion.position[d];
        const double rate = motion.speed[d];
        take(LimitRow{d, 1.0, position - degree.low, rate});
        take(LimitRow{d, -1.0, degree.high - position, -rate});
    }
}

}  // namespace

void LimitRows::add(const LimitRow& row) {
    if (count_ < kMostRows) rows_[count_++] = row;
}

bool LimitRows::select(const Model& model, const Motion& motion, double length) {
    clear();
    visit_stops(model, motion, [this, length](const LimitRow& row) {
        if (row.gap < kReachSteps * length * std::max(0.0, -row.rate) + kReach) add(row);
    });
    return count_ > 0;
}

bool LimitRows::select_touched(const Model& model, const Motion& motion) {
    clear();
    visit_stops(model, motion, [this](const LimitRow& row) {
        if (row.gap < kReach) add(row);
    });
    return count_ > 0;
}

void LimitRows::build(const Model& model, const Evaluation& evaluation) {
    double efforts[kMostJointDegrees] = {};
    Response response;
    for (int column = 0; column < count_; ++column) {
        const LimitRow& row = rows_[column];
        efforts[row.degree] = row.sign;
        respond(model, evaluation.kinematics, evaluation.factors, efforts, response);
        efforts[row.degree] = 0.0;
        for (int other = 0; other < count_; ++other)
            matrix_[other][column] = rows_[other].sign * response.joint[rows_[other].degree];
    }
    for (int i = 0; i < count_; ++i) {
        regularization_[i] = kRegularization * matrix_[i][i];
        matrix_[i][i] += regularization_[i];
    }
}

bool LimitRows::solve_step(const Model& model, const Evaluation& evaluation, double length) {
    build(model, evaluation);
    for (int i = 0; i < count_; ++i) {
        const LimitRow& row = rows_[i];
        bias_[i] = row.rate + length * row.sign * evaluation.response.joint[row.degree] +
                   slack_of(row, length);
    }
    return solve();
}

bool LimitRows::solve_impact(const Model& model, const Evaluation& evaluation) {
    build(model, evaluation);
    for (int i = 0; i < count_; ++i)
        bias_[i] = rows_[i].rate;
    return solve();
}

// Solves for the impulses of the active rows; those of the others are 0.
bool LimitRows::solve_active(const bool (&active)[kMostRows], const double* right,
                             double* solution) {
    int order[kMostRows];
    int size = 0;
    for (int i = 0; i < count_; ++i) {
        solution[i] = 0.0;
        if (active[i]) order[size++] = i;
    }
    double x[kMostRows];
    for (int i = 0; i < size; ++i) {
        x[i] = right[order[i]];
        for (int j = 0; j <= i; ++j) {
            double sum = matrix_[order[i]][order[j]];
            for (int k = 0; k < j; ++k)
                sum -= factor_[i][k] * factor_[j][k];
            if (i == j && !(sum > 0.0)) return false;
            factor_[i][j] = i == j ? std::sqrt(sum) : sum / factor_[j][j];
        }
        for (int k = 0; k < i; ++k)
            x[i] -= factor_[i][k] * x[k];
        x[i] /= factor_[i][i];
    }
    for (int i = size - 1; i >= 0; --i) {
        for (int k = i + 1; k < size; ++k)
            x[i] -= factor_[k][i] * x[k];
        x[i] /= factor_[i][i];
        solution[order[i]] = x[i];
    }
    return true;
}

// Changes the states of rows that break their law. Returns whether there were none.
bool LimitRows::settle(bool (&active)[kMostRows]) {
    double right[kMostRows];
    for (int i = 0; i < count_; ++i)
        right[i] = -bias_[i];
    for (int round = 0; round < kMostRounds; ++round) {
        if (!solve_active(active, right, impulse_)) return false;
        bool any = false;
        for (int i = 0; i < count_; ++i) {
            double rate = bias_[i];
            for (int j = 0; j < count_; ++j)
                rate += matrix_[i][j] * impulse_[j];
            const bool wrong = active[i] ? impulse_[i] < 0.0 : rate < 0.0;
            if (!wrong) continue;
            any = true;
            active[i] = !active[i];
            if (round >= kJointRounds) break;
        }
        if (!any) return true;
    }
    return false;
}

bool LimitRows::solve() {
    for (int i = 0; i < count_; ++i)
        active_[i] = bias_[i] < 0.0;
    const bool settled = settle(active_);
    for (int i = 0; i < count_; ++i)
        impulse_[i] = std::max(0.0, impulse_[i]);
    return settled;
}

bool LimitRows::holds_something() const {
    for (int i = 0; i < count_; ++i) {
        if (impulse_[i] > 0.0) return true;
    }
    return false;
}

void LimitRows::add_efforts(double scale, double* efforts) const {
    for (int i = 0; i < count_; ++i)
        efforts[rows_[i].degree] += scale * rows_[i].sign * impulse_[i];
}

double LimitRows::effect(int index) const {
    double sum = -regularization_[index] * impulse_[index];
    for (int j = 0; j < count_; ++j)
        sum += matrix_[index][j] * impulse_[j];
    return sum;
}

bool LimitRows::absorb(const double* changes, double* efforts) {
    if (!holds_something()) return false;
    double right[kMostRows];
    double undone[kMostRows];
    for (int i = 0; i < count_; ++i)
        right[i] = -rows_[i].sign * changes[rows_[i].degree];
    if (!solve_active(active_, right, undone)) return false;
    for (int i = 0; i < count_; ++i)
        efforts[rows_[i].degree] += rows_[i].sign * undone[i];
    return true;
}

double limit_overrun(const Model& model, const Motion& motion) {
    double most = 0.0;
    visit_stops(model, motion, [&most](const LimitRow& row) { most = std::max(most, -row.gap); });
    return most;
}

}  // namespace cambrian::spatial
