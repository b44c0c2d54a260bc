// Every row's unit impulse is propagated from its bodies to the roots. With u_i for what reaches
// joint i and f for what reaches the root,
//     W_rs = sum over joints of u_ri u_si / d_i  +  f_r Phi f_s,
// with the inverse Phi of the root's articulated inertia (R. Featherstone, Rigid Body Dynamics
// Algorithms, 2008, chapter 8: the factors of the joint-space inertia). Only the bodies on the
// paths from a row's bodies to their roots take part.

#include "planar/constraints/invariants.h"
#include "planar/constraints/rows.h"

#include <algorithm>
#include <bit>

namespace cambrian {
namespace {

constexpr int kMaxGroups = kMaxRows / kLanes + 1;
constexpr double kRelativeSoftness = 1e-7;
constexpr double kFreeShare = 0.02;

CAMBRIAN_INLINE int last_of(BodySet set) {
    return 63 ^ std::countl_zero(set);
}

// What reaches a joint or a root from the unit impulses of four rows, and the same multiplied by
// 1/d or by the root's inverse.
struct Arrival {
    Simd4d value, share;
};

struct Arrivals {
    Arrival joint[kMaxBodies];
    Arrival root[3 * kMaxTrees];
    BodySet bodies;  // on the paths of any of the four
};

// Four impulses on a body, about its pivot.
struct Impulse {
    Simd4d f_x, f_y, t;
};
using Impulses = Impulse[kMaxBodies];

CAMBRIAN_INLINE BodySet bodies_of(const PlanarModel& model, const ConstraintSystem& rows, int first,
                                  int end) {
    BodySet bodies = 0;
    for (int row = first; row < end; ++row) {
        bodies |= model.root_path[rows[row].body_a];
        if (rows[row].body_b >= 0) bodies |= model.root_path[rows[row].body_b];
    }
    return bodies;
}

CAMBRIAN_INLINE void clear(BodySet bodies, Impulses& impulses) {
    for (; bodies != 0; bodies &= bodies - 1) {
        Impulse& impulse = impulses[std::countr_zero(bodies)];
        impulse.f_x = Simd4d{};
        impulse.f_y = Simd4d{};
        impulse.t = Simd4d{};
    }
}

struct Wrench {
    double x, y, moment;
};

// Moves a wrench from the body's centre to its pivot.
CAMBRIAN_INLINE void put_wrench(const Kinematics& k, int body, const Wrench& wrench, int lane,
                                Impulses& impulses) {
    impulses[body].f_x[lane] = wrench.x;
    impulses[body].f_y[lane] = wrench.y;
    impulses[body].t[lane] = wrench.moment + k.s_x[body] * wrench.x + k.s_y[body] * wrench.y;
}

// Writes the effort of a joint as wrenches on its two bodies at the child's pivot.
CAMBRIAN_INLINE void put_effort(const PlanarModel& model, const Kinematics& k, int body,
                                double effort, int lane, Impulses& impulses) {
    const int p = model.parent[body];
    CAMBRIAN_TICK_ASSERT(p >= 0, "an effort acts between two bodies");
    if (model.motion[body] != JointMotion::kSlide) {
        impulses[body].t[lane] = effort;
        impulses[p].t[lane] = -effort;
        return;
    }
    const double x = effort * k.axis_x[body];
    const double y = effort * k.axis_y[body];
    impulses[body].f_x[lane] = x;
    impulses[body].f_y[lane] = y;
    impulses[p].f_x[lane] = -x;
    impulses[p].f_y[lane] = -y;
    impulses[p].t[lane] = -(k.z_x[body] * x + k.z_y[body] * y);
}

CAMBRIAN_INLINE void put_unit_impulse(const PlanarModel& model, const Kinematics& k, const Row& row,
                                      int lane, Impulses& impulses) {
    if (row.kind == RowKind::kLimit) {
        put_effort(model, k, row.body_a, row.dir_x, lane, impulses);
        return;
    }
    put_wrench(k, row.body_a, {row.dir_x, row.dir_y, row.moment_a}, lane, impulses);
    if (row.body_b < 0) return;
    put_wrench(k, row.body_b, {-row.dir_x, -row.dir_y, -row.moment_b}, lane, impulses);
}

CAMBRIAN_INLINE void arrive_at_root(const RootInverse& inverse, const Simd4d& x, const Simd4d& y,
                                    const Simd4d& t, int channel, Arrivals& arrivals) {
    arrivals.root[channel] = {x, inverse.xx * x + inverse.xy * y + inverse.xt * t};
    arrivals.root[channel + 1] = {y, inverse.xy * x + inverse.yy * y + inverse.yt * t};
    arrivals.root[channel + 2] = {t, inverse.xt * x + inverse.yt * y + inverse.tt * t};
}

// Does the first pass of solve_impulse, from the leaves to the root, for four impulses.
template <bool kHasPrismatic>
CAMBRIAN_INLINE void eliminate(const PlanarModel& model, const EvaluationCache& cache,
                               Impulses& impulses, Arrivals& arrivals) {
    const Kinematics& k = cache.kinematics;
    const Factors& factors = cache.factors;
    for (BodySet left = arrivals.bodies & ~model.roots; left != 0;) {
        const int i = last_of(left);
        left &= ~(BodySet{1} << i);
        CAMBRIAN_TICK_ASSERT(model.parent[i] >= 0 && model.parent[i] < i,
                             "a parent comes before its children");
        Impulse& parent = impulses[model.parent[i]];
        const Impulse& own = impulses[i];
        const bool is_prismatic = kHasPrismatic && model.motion[i] == JointMotion::kSlide;
        const Simd4d u = is_prismatic ? k.axis_x[i] * own.f_x + k.axis_y[i] * own.f_y : own.t;
        const Simd4d share = u * factors.inverse_d[i];
        const Simd4d passed_x = own.f_x - factors.w_x[i] * share;
        const Simd4d passed_y = own.f_y - factors.w_y[i] * share;
        const Simd4d left_over =
            is_prismatic ? own.t - factors.w_3[i] * share : Simd4d(factors.damping[i] * share);
        parent.f_x += passed_x;
        parent.f_y += passed_y;
        parent.t += k.z_x[i] * passed_x + k.z_y[i] * passed_y + left_over;
        arrivals.joint[i] = {u, share};
    }
    for (int tree = 0; tree < model.tree_count; ++tree) {
        const int root = model.tree_begin[tree];
        const bool reached = ((arrivals.bodies >> root) & 1U) != 0;
        const Impulse all = reached ? impulses[root] : Impulse{};
        arrive_at_root(factors.root[tree], all.f_x, all.f_y, all.t, 3 * tree, arrivals);
    }
}

// The couplings of four rows, each with four columns.
struct Block {
    Simd4d a = {}, b = {}, c = {}, d = {};

    // Adds the product of one joint or root component.
    CAMBRIAN_INLINE void add(const Simd4d& share, const Simd4d& value) {
        a += share[0] * value;
        b += share[1] * value;
        c += share[2] * value;
        d += share[3] * value;
    }
    CAMBRIAN_INLINE void store(double* line, std::ptrdiff_t stride) const {
        store_lanes(line, a);
        store_lanes(line + stride, b);
        store_lanes(line + 2 * stride, c);
        store_lanes(line + 3 * stride, d);
    }
};

// Stores the block of the rows from `first` on and the columns from `second` on, and its transpose.
CAMBRIAN_INLINE void store_block(int first, int second, Block& block, ConstraintSystem& rows) {
    block.store(rows.line(first) + second, rows.stride);
    if (first == second) return;
    transpose(block.a, block.b, block.c, block.d);
    block.store(rows.line(second) + first, rows.stride);
}

// Fills the blocks of the rows from `first` on and two groups of columns from `second` on.
CAMBRIAN_INLINE void fill_two_blocks(const PlanarModel& model, const Arrivals& row,
                                     const Arrivals* columns, int first, int second,
                                     ConstraintSystem& rows) {
    Block left_block;
    Block right_block;
    const BodySet columns_bodies = columns[0].bodies | columns[1].bodies;
    for (BodySet left = row.bodies & columns_bodies & ~model.roots; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left);
        const Simd4d& share = row.joint[i].share;
        left_block.add(share, columns[0].joint[i].value);
        right_block.add(share, columns[1].joint[i].value);
    }
    for (int channel = 0; channel < 3 * model.tree_count; ++channel) {
        const Simd4d& share = row.root[channel].share;
        left_block.add(share, columns[0].root[channel].value);
        right_block.add(share, columns[1].root[channel].value);
    }
    store_block(first, second, left_block, rows);
    store_block(first, second + kLanes, right_block, rows);
}

// Fills the block of the rows from `first` on and the columns from `second` on.
CAMBRIAN_INLINE void fill_block(const PlanarModel& model, const Arrivals& row,
                                const Arrivals& column, int first, int second,
                                ConstraintSystem& rows) {
    Block block;
    for (BodySet left = row.bodies & column.bodies & ~model.roots; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left);
        block.add(row.joint[i].share, column.joint[i].value);
    }
    for (int channel = 0; channel < 3 * model.tree_count; ++channel)
        block.add(row.root[channel].share, column.root[channel].value);
    store_block(first, second, block, rows);
}

// Returns the part of a row's diagonal element by the stretches of its bodies at rest, without
// joints.
double stretch_response(const PlanarModel& model, const RowStretches& stretches) {
    double response = 0.0;
    if (stretches.slot_a >= 0)
        response += stretches.effort_a * stretches.effort_a *
                    model.inverse_inertia[model.parent[stretches.slot_a]];
    if (stretches.slot_b >= 0)
        response += stretches.effort_b * stretches.effort_b *
                    model.inverse_inertia[model.parent[stretches.slot_b]];
    return response;
}

// If the mechanism hardly moves in a contact's direction, a millimetre of penetration would need a
// huge impulse. So the diagonal is at least 2 % of that of the same bodies without joints. Friction
// rows are softer, because the forces of two sticking parts with a joint between them are
// undetermined.
template <bool kDeforms>
CAMBRIAN_INLINE double regularization(const PlanarModel& model, const ConstraintSystem& rows,
                                      int row, double friction_softness) {
    const double diagonal = rows.coupling(row, row);
    if (rows[row].kind == RowKind::kLimit) return kRelativeSoftness * diagonal;
    const int a = rows[row].body_a;
    const int b = rows[row].body_b;
    CAMBRIAN_TICK_ASSERT(is_body(model, a) && is_body_or_ground(model, b), "a contact of bodies");
    double free =
        model.inverse_mass[a] + rows[row].moment_a * rows[row].moment_a * model.inverse_inertia[a];
    if (b >= 0)
        free += model.inverse_mass[b] +
                rows[row].moment_b * rows[row].moment_b * model.inverse_inertia[b];
    if constexpr (kDeforms) free += stretch_response(model, rows.stretches[row]);
    const bool rubs = rows[row].kind == RowKind::kFriction;
    const double softness = rubs ? friction_softness : kRelativeSoftness;
    return std::max(softness * free, kFreeShare * free - diagonal);
}

// Computes what arrives from the rows from `first` on, with 0 at joints that only `others` reach.
template <bool kHasPrismatic>
CAMBRIAN_INLINE void arrive(const PlanarModel& model, const EvaluationCache& cache,
                            const ConstraintSystem& rows, int first, BodySet others,
                            Arrivals& arrivals) {
    CAMBRIAN_TICK_ASSERT(arrivals.bodies != 0, "a row acts on bodies");
    Impulses impulses;
    clear(arrivals.bodies, impulses);
    for (int row = first; row < std::min(first + kLanes, rows.count); ++row)
        put_unit_impulse(model, cache.kinematics, rows[row], row - first, impulses);
    eliminate<kHasPrismatic>(model, cache, impulses, arrivals);
    for (BodySet left = others & ~arrivals.bodies; left != 0; left &= left - 1)
        arrivals.joint[std::countr_zero(left)].value = Simd4d{};
}

// Fills the rows of a group and its columns up to the diagonal. This is a separate function, so
// that gcc addresses the groups by pointers.
[[gnu::noinline]] void fill_rows(const PlanarModel& model, const Arrivals* groups, int first,
                                 ConstraintSystem& rows) {
    const Arrivals& group = groups[first / kLanes];
    int column = 0;
    for (; column < first; column += 2 * kLanes)
        fill_two_blocks(model, group, groups + column / kLanes, first, column, rows);
    if (column == first) fill_block(model, group, group, first, first, rows);
}

template <bool kHasPrismatic>
void fill_delassus_matrix(const PlanarModel& model, const EvaluationCache& cache,
                          ConstraintSystem& rows) {
    Arrivals arrivals[kMaxGroups];
    for (int first = 0; first < rows.count; first += 2 * kLanes) {
        Arrivals* pair = arrivals + first / kLanes;
        const int second = first + kLanes;
        pair[0].bodies = bodies_of(model, rows, first, std::min(second, rows.count));
        pair[1].bodies = bodies_of(model, rows, second, std::min(second + kLanes, rows.count));
        arrive<kHasPrismatic>(model, cache, rows, first, pair[1].bodies, pair[0]);
        fill_rows(model, arrivals, first, rows);
        if (second >= rows.count) return;
        arrive<kHasPrismatic>(model, cache, rows, second, pair[0].bodies, pair[1]);
        fill_rows(model, arrivals, second, rows);
    }
}

// Fills the matrix from the responses to the unit impulses of two rows at a time.
void fill_stretched_delassus_matrix(const PlanarModel& model, const EvaluationCache& cache,
                                    ConstraintSystem& rows) {
    for (int first = 0; first < rows.count; first += 2) {
        BodyResponse responses[2];
        double rates[2][kMaxRows];
        const int end = std::min(first + 2, rows.count);
        for (int row = first; row < first + 2; ++row) {
            double unit[kMaxRows] = {};
            if (row < end) unit[row] = 1.0;
            Loads loads;
            clear_loads(model, loads);
            add_row_impulses(rows, unit, 1.0, loads);
            solve_impulse(model, cache.kinematics, cache.factors, loads, responses[row - first]);
        }
        rate_rows(model, rows, responses, rates);
        for (int row = first; row < end; ++row) {
            for (int column = 0; column <= row; ++column) {
                rows.line(row)[column] = rates[row - first][column];
                rows.line(column)[row] = rates[row - first][column];
            }
        }
    }
    for (int row = 0; row < rows.count; ++row) {
        for (int pad = rows.count; pad < rows.stride; ++pad)
            rows.line(row)[pad] = 0.0;
    }
}

template <bool kDeforms>
CAMBRIAN_INLINE void regularize(const PlanarModel& model, double friction_softness,
                                ConstraintSystem& rows) {
    for (int row = 0; row < rows.count; ++row) {
        rows[row].regularization = regularization<kDeforms>(model, rows, row, friction_softness);
        rows.line(row)[row] += rows[row].regularization;
    }
    for (int pad = rows.count; pad < rows.stride; ++pad)
        rows.impulse[pad] = 0.0;
}

}  // namespace

void compute_delassus_matrix(const PlanarModel& model, const EvaluationCache& cache,
                             double friction_softness, ConstraintSystem& rows) {
    rows.stride = round_up_to_lanes(rows.count);
    if (rows.deforms) {
        fill_stretched_delassus_matrix(model, cache, rows);
        return regularize<true>(model, friction_softness, rows);
    }
    if (cache.is_inverted)
        fill_dense_delassus_matrix(model, cache, rows);
    else if (model.has_slides)
        fill_delassus_matrix<true>(model, cache, rows);
    else
        fill_delassus_matrix<false>(model, cache, rows);
    regularize<false>(model, friction_softness, rows);
}

}  // namespace cambrian
