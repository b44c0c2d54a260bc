#include "dynamics/row_matrix.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr int kLanes = 4;
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));

// Four impulses and the velocity jumps they cause.
struct LaneWork {
    Lanes f_x[kMaxBodies], f_y[kMaxBodies], t[kMaxBodies], effort[kMaxBodies], u[kMaxBodies];
    Lanes x[kMaxBodies], y[kMaxBodies], spin[kMaxBodies], coordinate[kMaxBodies];
};

void clear(int bodies, LaneWork& work) {
    const Lanes zero = {};
    for (int i = 0; i < bodies; ++i) {
        work.f_x[i] = zero;
        work.f_y[i] = zero;
        work.t[i] = zero;
        work.effort[i] = zero;
    }
}

void put_unit_impulse(const RowSystem& rows, int row, int lane, LaneWork& work) {
    const int a = rows.body_a[row];
    if (rows.kind[row] == RowKind::kLimit) {
        work.effort[a][lane] = rows.dir_x[row];
        return;
    }
    work.f_x[a][lane] = rows.dir_x[row];
    work.f_y[a][lane] = rows.dir_y[row];
    work.t[a][lane] = rows.moment_a[row];
    const int b = rows.body_b[row];
    if (b < 0) return;
    work.f_x[b][lane] = -rows.dir_x[row];
    work.f_y[b][lane] = -rows.dir_y[row];
    work.t[b][lane] = -rows.moment_b[row];
}

// As solve_impulse, on four right-hand sides.
void respond(const PlanarModel& model, const Frame& frame, LaneWork& work) {
    const Kinematics& k = frame.kinematics;
    const Factors& factors = frame.factors;
    for (int i = model.body_count - 1; i > 0; --i) {
        const int p = model.parent[i];
        const bool linear = model.joint[i] == JointType::kLinear;
        Lanes u = k.s_x[i] * work.f_x[i] + k.s_y[i] * work.f_y[i] + work.effort[i];
        if (!linear) u += work.t[i];
        const Lanes share = u * factors.inverse_d[i];
        const Lanes passed_x = work.f_x[i] - factors.w_x[i] * share;
        const Lanes passed_y = work.f_y[i] - factors.w_y[i] * share;
        work.u[i] = u;
        work.f_x[p] += passed_x;
        work.f_y[p] += passed_y;
        work.t[p] += k.z_x[i] * passed_x + k.z_y[i] * passed_y;
        if (linear)
            work.t[p] += work.t[i] - factors.w_3[i] * share;
        else
            work.t[p] -= work.effort[i];
    }
    const Lanes f_x = work.f_x[0];
    const Lanes f_y = work.f_y[0];
    const Lanes t = work.t[0];
    work.x[0] = factors.root_xx * f_x + factors.root_xy * f_y + factors.root_xt * t;
    work.y[0] = factors.root_xy * f_x + factors.root_yy * f_y + factors.root_yt * t;
    work.spin[0] = factors.root_xt * f_x + factors.root_yt * f_y + factors.root_tt * t;
    for (int i = 1; i < model.body_count; ++i) {
        const int p = model.parent[i];
        const bool linear = model.joint[i] == JointType::kLinear;
        const Lanes x = work.x[p] + k.z_x[i] * work.spin[p];
        const Lanes y = work.y[p] + k.z_y[i] * work.spin[p];
        Lanes rest = work.u[i] - factors.w_x[i] * x - factors.w_y[i] * y;
        if (linear) rest -= factors.w_3[i] * work.spin[p];
        const Lanes coordinate = rest * factors.inverse_d[i];
        work.x[i] = x + k.s_x[i] * coordinate;
        work.y[i] = y + k.s_y[i] * coordinate;
        work.spin[i] = linear ? work.spin[p] : coordinate;
        // What the joint's limit row sees.
        work.coordinate[i] = linear ? coordinate : coordinate - work.spin[p];
    }
}

void read_rates(const RowSystem& rows, int row, const LaneWork& work, Lanes& rates) {
    const int a = rows.body_a[row];
    if (rows.kind[row] == RowKind::kLimit) {
        rates = rows.dir_x[row] * work.coordinate[a];
        return;
    }
    rates = rows.dir_x[row] * work.x[a] + rows.dir_y[row] * work.y[a] +
            rows.moment_a[row] * work.spin[a];
    const int b = rows.body_b[row];
    if (b < 0) return;
    rates -= rows.dir_x[row] * work.x[b] + rows.dir_y[row] * work.y[b] +
             rows.moment_b[row] * work.spin[b];
}

// A contact on a body that the mechanism hardly lets move would answer a millimetre with a huge
// impulse; the diagonal is kept above 2 % of that of the bodies set free.
double regularization(const PlanarModel& model, const RowSystem& rows, int row) {
    constexpr double kRelative = 1e-7;
    constexpr double kFreeShare = 0.02;
    const double diagonal = rows.coupling(row, row);
    if (rows.kind[row] == RowKind::kLimit) return kRelative * diagonal;
    const int a = rows.body_a[row];
    const int b = rows.body_b[row];
    double free = 1.0 / model.mass[a] + rows.moment_a[row] * rows.moment_a[row] / model.inertia[a];
    if (b >= 0)
        free += 1.0 / model.mass[b] + rows.moment_b[row] * rows.moment_b[row] / model.inertia[b];
    return std::fmax(kRelative * free, kFreeShare * free - diagonal);
}

}  // namespace

void compute_row_matrix(const PlanarModel& model, const Frame& frame, RowSystem& rows) {
    rows.stride = (rows.count + kLanes - 1) / kLanes * kLanes;
    LaneWork work;
    for (int first = 0; first < rows.count; first += kLanes) {
        const int lanes = rows.count - first < kLanes ? rows.count - first : kLanes;
        clear(model.body_count, work);
        for (int lane = 0; lane < lanes; ++lane)
            put_unit_impulse(rows, first + lane, lane, work);
        respond(model, frame, work);
        for (int row = first; row < rows.count; ++row) {
            Lanes rates;
            read_rates(rows, row, work, rates);
            for (int lane = 0; lane < lanes; ++lane) {
                rows.matrix[row * rows.stride + first + lane] = rates[lane];
                rows.matrix[(first + lane) * rows.stride + row] = rates[lane];
            }
        }
    }
    for (int row = 0; row < rows.count; ++row) {
        rows.regularization[row] = regularization(model, rows, row);
        rows.matrix[row * rows.stride + row] += rows.regularization[row];
    }
}

}  // namespace cambrian
