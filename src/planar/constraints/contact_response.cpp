// Simultaneous impact of all touching contacts, with restitution and friction (planar/README.md
// 12):
//     u+ = u- + W p,   normal rows that close fast: u+ >= -e u-,   all others: u+ >= 0.
// The change of energy is exactly p (u- + u+) / 2. Friction can make it positive, which is
// impossible for real surfaces. Then the problem is solved again without restitution and, if
// necessary, without friction.

#include "planar/constraints/contact_solver.h"
#include "planar/constraints/invariants.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kStopBand = 1e-3;       // rad or m; joints nearer to a limit are in the impact
constexpr double kWorkTolerance = 1e-6;  // of the impulses' size times their closing speeds
// Softness is small, because an impact has no earlier impulse to anchor its friction rows.
constexpr double kImpactFrictionSoftness = 1e-5;

void set_impact_bias(const ConstraintSystem& rows, double restitution, double* bias) {
    for (int row = 0; row < rows.count; ++row) {
        const double rate = rows[row].rate;
        const bool bounces = rows[row].kind == RowKind::kNormal && rate < -kRestingSpeed;
        bias[row] = bounces ? (1.0 + restitution) * rate : rate;
    }
}

double impact_scale(const ConstraintSystem& rows) {
    double scale = 0.0;
    for (int row = 0; row < rows.count; ++row)
        scale += std::fabs(rows.impulse[row] * rows[row].rate);
    return scale;
}

void find_stops(const PlanarModel& model, const Kinematics& kinematics, LimitSet& limits) {
    limits.count = 0;
    for (int i = 0; i < model.body_count; ++i) {
        if (model.parent[i] < 0) continue;
        CAMBRIAN_TICK_ASSERT(model.limit_low[i] <= model.limit_high[i], "stops in order");
        const double angle = kinematics.joint_position[i];
        const double low = angle - model.limit_low[i];
        const double high = model.limit_high[i] - angle;
        if (low < kStopBand) limits.add({i, 1.0, low});
        if (high < kStopBand) limits.add({i, -1.0, high});
    }
}

}  // namespace

double ContactSolver::impact_work_of_row(int row) const {
    return rows_.impulse[row] * (rows_[row].rate + 0.5 * impulse_effect(rows_, row));
}

double ContactSolver::impact_work() const {
    double work = 0.0;
    for (int row = 0; row < rows_.count; ++row) {
        if (rows_.impulse[row] == 0.0) continue;
        work += impact_work_of_row(row);
    }
    return work;
}

double ContactSolver::impact_work_of(int contact) const {
    double work = 0.0;
    for (int row = 0; row < rows_.count; ++row) {
        if (rows_[row].kind == RowKind::kLimit || rows_[row].source != contact) continue;
        if (rows_.impulse[row] != 0.0) work += impact_work_of_row(row);
    }
    return work;
}

double ContactSolver::normal_impulse_of(int contact) const {
    for (int row = 0; row < rows_.count; ++row) {
        if (rows_[row].kind == RowKind::kNormal && rows_[row].source == contact)
            return rows_.impulse[row];
    }
    return 0.0;
}

ImpactResult ContactSolver::solve_impact(const PlanarModel& model, const ContactLaw& law,
                                         double restitution, const EvaluationCache& cache,
                                         Motion& motion) {
    CAMBRIAN_TICK_ASSERT(restitution >= 0.0 && restitution <= 1.0, "a coefficient of restitution");
    selected_.count = 0;
    selected_.most = near_.most;
    for (int c = 0; c < near_.count; ++c) {
        if (near_.items[c].gap < kContactBand) selected_.add(near_.items[c]);
    }
    find_stops(model, cache.kinematics, limits_);
    build_rows(model, {selected_, limits_, law.friction > 0.0, kImpactFrictionSoftness},
               cache.kinematics, cache, rows_);
    ImpactResult result;
    const auto solve = [&](double kept) {
        for (int row = 0; row < rows_.count; ++row)
            rows_.impulse[row] = 0.0;
        set_impact_bias(rows_, kept, bias_);
        if (!solver_.solve(rows_, bias_, law.friction)) result.fell_back = true;
        result.work = impact_work();
        return result.work <= kWorkTolerance * impact_scale(rows_);
    };
    if (!solve(restitution) && !solve(0.0)) {
        result.fell_back = true;
        solver_.iterate_from_zero(rows_, bias_, 0.0);
        result.work = impact_work();
    }
    CAMBRIAN_TICK_ASSERT(do_only_push(rows_), "an impact does not pull");
    CAMBRIAN_TICK_ASSERT(result.fell_back || are_in_cones(rows_, law.friction),
                         "friction that is solved for stays in its cone");
    Loads loads;
    BodyResponse jump;
    clear_loads(model, loads);
    add_row_impulses(rows_, rows_.impulse, 1.0, loads);
    solve_impulse(model, cache.kinematics, cache.factors, loads, jump);
    for (int c = 0; c < coordinate_count(model); ++c)
        motion.speed[c] += jump.coordinate[c];
    return result;
}

}  // namespace cambrian
