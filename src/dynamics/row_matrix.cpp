#include "dynamics/row_matrix.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace cambrian {
namespace {

// Four impulses and the velocity jumps they cause.
struct LaneWork {
    Lanes f_x[kMaxBodies], f_y[kMaxBodies], t[kMaxBodies], effort[kMaxBodies], u[kMaxBodies];
    Lanes x[kMaxBodies], y[kMaxBodies], spin[kMaxBodies], coordinate[kMaxBodies];
};

using BodySet = std::uint32_t;  // one bit a body

constexpr double kRelativeSoftness = 1e-7;
constexpr double kFrictionSoftness = 1e-2;
constexpr double kFreeShare = 0.02;

inline int first_of(BodySet set) {
    return std::countr_zero(set);
}
inline int last_of(BodySet set) {
    return 31 - std::countl_zero(set);
}

BodySet bodies_of(const PlanarModel& model, const RowSystem& rows, int first, int end) {
    BodySet bodies = 0;
    for (int row = first; row < end; ++row) {
        bodies |= model.root_path[rows.body_a[row]];
        if (rows.body_b[row] >= 0) bodies |= model.root_path[rows.body_b[row]];
    }
    return bodies;
}

CAMBRIAN_INLINE void clear(BodySet bodies, LaneWork& work) {
    const Lanes zero = {};
    for (; bodies != 0; bodies &= bodies - 1) {
        const int i = first_of(bodies);
        work.f_x[i] = zero;
        work.f_y[i] = zero;
        work.t[i] = zero;
        work.effort[i] = zero;
        work.u[i] = zero;
    }
}

CAMBRIAN_INLINE void put_unit_impulse(const RowSystem& rows, int row, int lane, LaneWork& work) {
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

// As solve_impulse, on four right-hand sides: pushed bodies (with their paths to the root) pass
// their impulses on, moved ones get their velocities.
CAMBRIAN_INLINE void respond(const PlanarModel& model, const Frame& frame, BodySet pushed,
                             BodySet moved, LaneWork& work) {
    const Kinematics& k = frame.kinematics;
    const Factors& factors = frame.factors;
    for (BodySet left = pushed & ~model.roots; left != 0; left ^= BodySet{1} << last_of(left)) {
        const int i = last_of(left);
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
    for (int tree = 0; tree < model.tree_count; ++tree) {
        const int root = model.tree_begin[tree];
        const RootInverse& inverse = factors.root[tree];
        const Lanes f_x = work.f_x[root];
        const Lanes f_y = work.f_y[root];
        const Lanes t = work.t[root];
        work.x[root] = inverse.xx * f_x + inverse.xy * f_y + inverse.xt * t;
        work.y[root] = inverse.xy * f_x + inverse.yy * f_y + inverse.yt * t;
        work.spin[root] = inverse.xt * f_x + inverse.yt * f_y + inverse.tt * t;
    }
    for (BodySet left = moved & ~model.roots; left != 0; left &= left - 1) {
        const int i = first_of(left);
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

CAMBRIAN_INLINE void read_rates(const RowSystem& rows, int row, const LaneWork& work,
                                Lanes& rates) {
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
// impulse; the diagonal is kept above 2 % of that of the bodies set free. Friction rows are softer:
// two parts that stick and a joint between them would leave their forces undetermined.
double regularization(const PlanarModel& model, const RowSystem& rows, int row) {
    const double diagonal = rows.coupling(row, row);
    if (rows.kind[row] == RowKind::kLimit) return kRelativeSoftness * diagonal;
    const int a = rows.body_a[row];
    const int b = rows.body_b[row];
    double free = 1.0 / model.mass[a] + rows.moment_a[row] * rows.moment_a[row] / model.inertia[a];
    if (b >= 0)
        free += 1.0 / model.mass[b] + rows.moment_b[row] * rows.moment_b[row] / model.inertia[b];
    const bool rubs = rows.kind[row] == RowKind::kFriction;
    const double softness = rubs ? kFrictionSoftness : kRelativeSoftness;
    return std::max(softness * free, kFreeShare * free - diagonal);
}

}  // namespace

CAMBRIAN_WIDE void compute_row_matrix(const PlanarModel& model, const Frame& frame,
                                      RowSystem& rows) {
    rows.stride = round_up_to_lanes(rows.count);
    const BodySet moved = bodies_of(model, rows, 0, rows.count) | model.roots;
    LaneWork work;
    for (int first = 0; first < rows.count; first += kLanes) {
        const int lanes = std::min(rows.count - first, kLanes);
        clear(moved, work);
        for (int lane = 0; lane < lanes; ++lane)
            put_unit_impulse(rows, first + lane, lane, work);
        respond(model, frame, bodies_of(model, rows, first, first + lanes), moved, work);
        for (int row = first; row < rows.count; ++row) {
            Lanes rates;
            read_rates(rows, row, work, rates);
            std::memcpy(&rows.matrix[row * rows.stride + first], &rates, sizeof(rates));
            for (int lane = 0; lane < lanes; ++lane)
                rows.matrix[(first + lane) * rows.stride + row] = rates[lane];
        }
    }
    for (int row = 0; row < rows.count; ++row) {
        for (int pad = rows.count; pad < rows.stride; ++pad)
            rows.matrix[row * rows.stride + pad] = 0.0;
        rows.regularization[row] = regularization(model, rows, row);
        rows.matrix[row * rows.stride + row] += rows.regularization[row];
    }
    for (int pad = rows.count; pad < rows.stride; ++pad)
        rows.impulse[pad] = 0.0;
}

}  // namespace cambrian
