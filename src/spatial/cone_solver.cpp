#include "spatial/cone_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cambrian::spatial {
namespace {

constexpr int kFirstSweeps = 5;
constexpr int kRounds = 20;
constexpr double kTolerance = 1e-11;      // of the largest bias
constexpr double kLeastBias = 1e-3;       // m/s or rad/s
constexpr double kSweepTolerance = 1e-6;  // m/s or rad/s

double sum_of(const double* row, const double* impulse, int count) {
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
        sum += row[i] * impulse[i];
    return sum;
}

double length_of(double x, double y) {
    return std::sqrt(x * x + y * y);
}

// Returns 1 / a bound of the tangents' block, by which both of them are scaled.
double tangent_scale(const ConeProblem& problem, int first) {
    const int n = problem.rows();
    const double* row = problem.matrix + first * n;
    return 1.0 / (std::max(row[first], row[n + first + 1]) + std::fabs(row[first + 1]));
}

void keep_in_circle(double radius, double* tangent) {
    const double length = length_of(tangent[0], tangent[1]);
    if (length <= radius) return;
    for (int k = 0; k < 2; ++k)
        tangent[k] *= radius / length;
}

// Solves a x = x by elimination with pivots from the column. Returns false if the matrix is
// singular.
bool eliminate(int size, double* a, double* x) {
    for (int i = 0; i < size; ++i) {
        int pivot = i;
        for (int j = i + 1; j < size; ++j) {
            if (std::fabs(a[j * size + i]) > std::fabs(a[pivot * size + i])) pivot = j;
        }
        if (!(std::fabs(a[pivot * size + i]) > 0.0)) return false;
        if (pivot != i) {
            std::swap_ranges(a + i * size + i, a + (i + 1) * size, a + pivot * size + i);
            std::swap(x[i], x[pivot]);
        }
        const double inverse = 1.0 / a[i * size + i];
        for (int j = i + 1; j < size; ++j) {
            const double factor = a[j * size + i] * inverse;
            if (factor == 0.0) continue;
            for (int k = i + 1; k < size; ++k)
                a[j * size + k] -= factor * a[i * size + k];
            x[j] -= factor * x[i];
        }
    }
    for (int i = size - 1; i >= 0; --i) {
        for (int k = i + 1; k < size; ++k)
            x[i] -= a[i * size + k] * x[k];
        x[i] /= a[i * size + i];
        if (!std::isfinite(x[i])) return false;
    }
    return true;
}

}  // namespace

ConeSolver::ConeSolver(int most_rows) {
    const auto rows = static_cast<std::size_t>(most_rows);
    for (std::vector<double>* numbers : {&scale_, &rate_, &residual_, &direction_})
        numbers->resize(rows);
    jacobian_.resize(rows * rows);
    reduced_.resize(rows * rows);
    pushing_.reserve(rows);
    is_off_.resize(rows);
}

void ConeSolver::sweep(const ConeProblem& problem, int sweeps, double* p) {
    const int n = problem.rows();
    const auto rate = [&](int row) {
        return problem.bias[row] + sum_of(problem.matrix + row * n, p, n);
    };
    double change = 0.0;
    const auto push = [&](int row) {
        const double diagonal = problem.matrix[row * n + row];
        const double pushed = std::max(0.0, p[row] - rate(row) / diagonal);
        change = std::max(change, std::fabs(pushed - p[row]) * diagonal);
        p[row] = pushed;
    };
    for (int round = 0; round < sweeps; ++round) {
        change = 0.0;
        for (int first = 0; first < 3 * problem.contacts; first += 3) {
            push(first);
            const double scale = tangent_scale(problem, first + 1);
            double moved[2] = {p[first + 1] - scale * rate(first + 1),
                               p[first + 2] - scale * rate(first + 2)};
            keep_in_circle(problem.friction * p[first], moved);
            for (int k = 0; k < 2; ++k) {
                change = std::max(change, std::fabs(moved[k] - p[first + 1 + k]) / scale);
                p[first + 1 + k] = moved[k];
            }
        }
        for (int row = 3 * problem.contacts; row < n; ++row)
            push(row);
        if (change < kSweepTolerance) return;
    }
}

void ConeSolver::compute_rates(const ConeProblem& problem, const double* p) {
    const int n = problem.rows();
    for (int row = 0; row < n; ++row)
        rate_[static_cast<std::size_t>(row)] =
            problem.bias[row] + sum_of(problem.matrix + row * n, p, n);
}

// Computes the residuals and derivatives of the two tangents of a contact that slips along z.
void ConeSolver::linearize_slip(const ConeProblem& problem, const double* p, int first,
                                const double (&z)[2]) {
    const int n = problem.rows();
    const double* scale = scale_.data();
    const double rho = scale[first + 1];
    const double length = length_of(z[0], z[1]);
    const double radius =
        problem.friction * (p[first] - scale[first] * rate_[static_cast<std::size_t>(first)]);
    // Slip: (p_t - radius z / |z|) / rho.
    const double way[2] = {z[0] / length, z[1] / length};
    const double share = radius / length;
    const double* normal_row = problem.matrix + first * n;
    const double* tangent_rows = normal_row + n;
    for (int k = 0; k < 2; ++k) {
        const int row = first + 1 + k;
        const double to[2] = {share * ((k == 0 ? 1.0 : 0.0) - way[k] * way[0]),
                              share * ((k == 1 ? 1.0 : 0.0) - way[k] * way[1])};
        const double pressed = way[k] * problem.friction / rho;
        residual_[static_cast<std::size_t>(row)] = (p[row] - radius * way[k]) / rho;
        double* derivative = jacobian_.data() + row * n;
        for (int j = 0; j < n; ++j)
            derivative[j] = pressed * scale[first] * normal_row[j] +
                            (to[0] * tangent_rows[j] + to[1] * tangent_rows[n + j]);
        derivative[first] -= pressed;
        derivative[first + 1] -= to[0] / rho;
        derivative[first + 2] -= to[1] / rho;
        derivative[row] += 1.0 / rho;
    }
}

// Computes the residuals of all rows and the derivatives of those that push. Returns the largest
// residual.
double ConeSolver::linearize(const ConeProblem& problem, const double* p) {
    const int n = problem.rows();
    double* y = rate_.data();
    double* scale = scale_.data();
    double* residual = residual_.data();
    pushing_.clear();
    const auto turn_off = [&](int row) {
        is_off_[static_cast<std::size_t>(row)] = 1;
        residual[row] = p[row] / scale[row];
    };
    const auto turn_on = [&](int row) {
        is_off_[static_cast<std::size_t>(row)] = 0;
        pushing_.push_back(row);
        residual[row] = y[row];
        std::copy_n(problem.matrix + row * n, n, jacobian_.data() + row * n);
    };
    for (int first = 0; first < 3 * problem.contacts; first += 3) {
        const double normal = p[first] - scale[first] * y[first];
        if (normal <= 0.0) {
            for (int k = 0; k < 3; ++k)
                turn_off(first + k);
            continue;
        }
        for (int k = 0; k < 3; ++k)
            turn_on(first + k);
        const double rho = scale[first + 1];
        const double z[2] = {p[first + 1] - rho * y[first + 1], p[first + 2] - rho * y[first + 2]};
        if (length_of(z[0], z[1]) > problem.friction * normal) linearize_slip(problem, p, first, z);
    }
    for (int row = 3 * problem.contacts; row < n; ++row) {
        if (p[row] - scale[row] * y[row] <= 0.0)
            turn_off(row);
        else
            turn_on(row);
    }
    double largest = 0.0;
    for (int row = 0; row < n; ++row)
        largest = std::max(largest, std::fabs(residual[row]));
    return largest;
}

// Takes Newton's step: rows that are off lose their impulses, the others follow by elimination.
// Returns false if the matrix is singular.
bool ConeSolver::step(const ConeProblem& problem, double* p) {
    const int n = problem.rows();
    const int size = static_cast<int>(pushing_.size());
    const int* rows = pushing_.data();
    double* a = reduced_.data();
    double* x = direction_.data();
    for (int i = 0; i < size; ++i) {
        const double* derivative = jacobian_.data() + rows[i] * n;
        x[i] = residual_[static_cast<std::size_t>(rows[i])];
        for (int j = 0; j < n; ++j) {
            if (is_off_[static_cast<std::size_t>(j)] != 0 && p[j] != 0.0)
                x[i] -= derivative[j] * p[j];
        }
        for (int j = 0; j < size; ++j)
            a[i * size + j] = derivative[rows[j]];
    }
    if (!eliminate(size, a, x)) return false;
    for (int row = 0; row < n; ++row) {
        if (is_off_[static_cast<std::size_t>(row)] != 0) p[row] = 0.0;
    }
    for (int i = 0; i < size; ++i)
        p[rows[i]] -= x[i];
    for (int first = 0; first < 3 * problem.contacts; first += 3) {
        if (p[first] < 0.0) std::fill_n(p + first, 3, 0.0);
    }
    for (int row = 3 * problem.contacts; row < n; ++row)
        p[row] = std::max(0.0, p[row]);
    return true;
}

bool ConeSolver::solve(const ConeProblem& problem, double* p) {
    const int n = problem.rows();
    double allowed = kLeastBias;
    for (int row = 0; row < n; ++row) {
        allowed = std::max(allowed, std::fabs(problem.bias[row]));
        scale_[static_cast<std::size_t>(row)] = 1.0 / problem.matrix[row * n + row];
    }
    allowed *= kTolerance;
    for (int first = 1; first < 3 * problem.contacts; first += 3) {
        const double scale = tangent_scale(problem, first);
        std::fill_n(scale_.data() + first, 2, scale);
    }
    sweep(problem, kFirstSweeps, p);
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kRounds; ++round) {
        compute_rates(problem, p);
        const double residual = linearize(problem, p);
        if (residual < allowed) return true;
        if (residual > 0.5 * before && round % 3 == 2) {
            sweep(problem, kFirstSweeps, p);
            before = std::numeric_limits<double>::infinity();
            continue;
        }
        before = std::min(before, residual);
        if (!step(problem, p)) break;
    }
    for (int first = 0; first < 3 * problem.contacts; first += 3)
        keep_in_circle(problem.friction * p[first], p + first + 1);
    return false;
}

}  // namespace cambrian::spatial
