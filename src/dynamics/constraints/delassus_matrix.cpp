// Every row's unit impulse is propagated from its bodies to the roots. With u_i for what reaches
// joint i and f for what reaches the root,
//     W_rs = sum over joints of u_ri u_si / d_i  +  f_r Phi f_s,
// with the inverse Phi of the root's articulated inertia (R. Featherstone, Rigid Body Dynamics
// Algorithms, 2008, chapter 8: the factors of the joint-space inertia). Only the bodies on the
// paths from a row's bodies to their roots take part.

#include "dynamics/constraints/delassus_matrix.h"

#include "dynamics/constraints/dense_delassus_matrix.h"
#include "dynamics/constraints/invariants.h"

#include <algorithm>
#include <bit>

namespace cambrian {
namespace {

constexpr int kMaxGroups = kMaxRows / kLanes;
constexpr double kRelativeSoftness = 1e-7;
constexpr double kFreeShare = 0.02;

CAMBRIAN_INLINE int last_of(BodySet set) {
    return 63 - std::countl_zero(set);
}

// The unit impulses of four rows as they reach joints and roots, and the same multiplied by 1/d or
// by the root's inverse.
struct Arrivals {
    BodySet bodies;  // on the paths of any of the four
    Simd4d joint[kMaxBodies], joint_share[kMaxBodies];
    Simd4d root[3 * kMaxTrees], root_share[3 * kMaxTrees];
};

// Impulses about the bodies' pivots.
struct Impulses {
    Simd4d f_x[kMaxBodies], f_y[kMaxBodies], t[kMaxBodies];
};

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
        const int i = std::countr_zero(bodies);
        impulses.f_x[i] = Simd4d{};
        impulses.f_y[i] = Simd4d{};
        impulses.t[i] = Simd4d{};
    }
}

struct Wrench {
    double x, y, moment;
};

// Moves a wrench from the body's centre to its pivot.
CAMBRIAN_INLINE void put_wrench(const Kinematics& k, int body, const Wrench& wrench, int lane,
                                Impulses& impulses) {
    impulses.f_x[body][lane] = wrench.x;
    impulses.f_y[body][lane] = wrench.y;
    impulses.t[body][lane] = wrench.moment + k.s_x[body] * wrench.x + k.s_y[body] * wrench.y;
}

// Writes the effort of a joint as wrenches on its two bodies at the child's pivot.
CAMBRIAN_INLINE void put_effort(const PlanarModel& model, const Kinematics& k, int body,
                                double effort, int lane, Impulses& impulses) {
    const int p = model.parent[body];
    CAMBRIAN_TICK_ASSERT(p >= 0, "an effort acts between two bodies");
    if (model.motion[body] != JointMotion::kSlide) {
        impulses.t[body][lane] = effort;
        impulses.t[p][lane] = -effort;
        return;
    }
    const double x = effort * k.axis_x[body];
    const double y = effort * k.axis_y[body];
    impulses.f_x[body][lane] = x;
    impulses.f_y[body][lane] = y;
    impulses.f_x[p][lane] = -x;
    impulses.f_y[p][lane] = -y;
    impulses.t[p][lane] = -(k.z_x[body] * x + k.z_y[body] * y);
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
    arrivals.root[channel] = x;
    arrivals.root[channel + 1] = y;
    arrivals.root[channel + 2] = t;
    arrivals.root_share[channel] = inverse.xx * x + inverse.xy * y + inverse.xt * t;
    arrivals.root_share[channel + 1] = inverse.xy * x + inverse.yy * y + inverse.yt * t;
    arrivals.root_share[channel + 2] = inverse.xt * x + inverse.yt * y + inverse.tt * t;
}

// Does the first pass of solve_impulse, from the leaves to the root, for four impulses.
template <bool kHasPrismatic>
CAMBRIAN_INLINE void eliminate(const PlanarModel& model, const EvaluationCache& cache,
                               Impulses& impulses, Arrivals& arrivals) {
    const Kinematics& k = cache.kinematics;
    const Factors& factors = cache.factors;
    const BodySet inner = arrivals.bodies & ~model.roots;
    for (BodySet left = inner; left != 0; left ^= BodySet{1} << last_of(left)) {
        const int i = last_of(left);
        const int p = model.parent[i];
        CAMBRIAN_TICK_ASSERT(p >= 0 && p < i, "a parent comes before its children");
        const Simd4d f_x = impulses.f_x[i];
        const Simd4d f_y = impulses.f_y[i];
        const Simd4d t = impulses.t[i];
        const bool is_prismatic = kHasPrismatic && model.motion[i] == JointMotion::kSlide;
        const Simd4d u = is_prismatic ? k.axis_x[i] * f_x + k.axis_y[i] * f_y : t;
        const Simd4d share = u * factors.inverse_d[i];
        const Simd4d passed_x = f_x - factors.w_x[i] * share;
        const Simd4d passed_y = f_y - factors.w_y[i] * share;
        const Simd4d left_over =
            is_prismatic ? t - factors.w_3[i] * share : Simd4d(factors.damping[i] * share);
        impulses.f_x[p] += passed_x;
        impulses.f_y[p] += passed_y;
        impulses.t[p] += k.z_x[i] * passed_x + k.z_y[i] * passed_y + left_over;
        arrivals.joint[i] = u;
        arrivals.joint_share[i] = share;
    }
    for (int tree = 0; tree < model.tree_count; ++tree) {
        const int root = model.tree_begin[tree];
        const bool reached = ((arrivals.bodies >> root) & 1U) != 0;
        const Simd4d none = {};
        arrive_at_root(factors.root[tree], reached ? impulses.f_x[root] : none,
                       reached ? impulses.f_y[root] : none, reached ? impulses.t[root] : none,
                       3 * tree, arrivals);
    }
}

// Adds the product of one joint or root component to a block of 4 x 4 rows.
CAMBRIAN_INLINE void add_product(const Simd4d& share, const Simd4d& value,
                                 Simd4d (&block)[kLanes]) {
    for (int i = 0; i < kLanes; ++i)
        block[i] += share[i] * value;
}

// Fills the block of rows from `first` on and columns from `second` on, and its transpose.
CAMBRIAN_INLINE void fill_block(const PlanarModel& model, const Arrivals& row,
                                const Arrivals& column, int first, int second,
                                ConstraintSystem& rows) {
    Simd4d block[kLanes] = {};
    const BodySet common = row.bodies & column.bodies & ~model.roots;
    for (BodySet left = common; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left);
        add_product(row.joint_share[i], column.joint[i], block);
    }
    for (int channel = 0; channel < 3 * model.tree_count; ++channel)
        add_product(row.root_share[channel], column.root[channel], block);
    for (int i = 0; i < kLanes; ++i)
        store_lanes(rows.line(first + i) + second, block[i]);
    if (first == second) return;
    transpose(block[0], block[1], block[2], block[3]);
    for (int i = 0; i < kLanes; ++i)
        store_lanes(rows.line(second + i) + first, block[i]);
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

template <bool kHasPrismatic>
void fill_delassus_matrix(const PlanarModel& model, const EvaluationCache& cache,
                          ConstraintSystem& rows) {
    Arrivals arrivals[kMaxGroups];
    for (int first = 0; first < rows.count; first += kLanes) {
        Arrivals& group = arrivals[first / kLanes];
        const int lanes = std::min(rows.count - first, kLanes);
        group.bodies = bodies_of(model, rows, first, first + lanes);
        CAMBRIAN_TICK_ASSERT(group.bodies != 0, "a row acts on bodies");
        Impulses impulses;
        clear(group.bodies, impulses);
        for (int lane = 0; lane < lanes; ++lane)
            put_unit_impulse(model, cache.kinematics, rows[first + lane], lane, impulses);
        eliminate<kHasPrismatic>(model, cache, impulses, group);
        for (int column = 0; column <= first; column += kLanes)
            fill_block(model, group, arrivals[column / kLanes], first, column, rows);
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
