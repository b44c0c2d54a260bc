#include "planar/articulated/articulated_body.h"

#include "core/assert.h"
#include "planar/model/planar_model.h"

namespace cambrian {
namespace {

// Articulated inertia [[A, h], [h', j]] and bias force (f, t) of a subtree about the body's pivot.
// Stored by columns with the components (x, y, turn, load). Component 2 of x and y is unused,
// because h is in turn. The transformation to the parent's pivot is (z, -gamma) of the x axis and
// then of the y axis.
struct ArticulatedInertia {
    Simd4d x, y, turn;
    Simd4d to_parent;
};

// Transformation from a child's pivot to its parent's: (0, 0, z, -gamma) for each axis.
struct Lever {
    Simd4d x, y;
};

enum class Load { kForce, kImpulse };
enum class Joints { kRevolute, kAny };

// Returns the efforts of revolute joints, a torque on the child and its parent.
template <Joints kJoints>
CAMBRIAN_INLINE Simd4d revolute_effort(const PlanarModel& model, const Simd4d& effort, int first) {
    return kJoints == Joints::kAny ? (1.0 - load_lanes(model.slides + first)) * effort : effort;
}

// The efforts of all joints, from which a vector with the effort in component `load` is loaded.
struct Efforts {
    double values[kLanes - 1 + kMaxBodies];
};

// Sets the body's own inertia and load: h = m s, f with the centrifugal force of the centre about
// the pivot, and t about the pivot with the effort of the body's joint; and the transformation to
// the parent.
template <Joints kJoints>
CAMBRIAN_INLINE void load_bodies(const PlanarModel& model, const Kinematics& k, const Loads& loads,
                                 ArticulatedInertia* inertias, Efforts& efforts) {
    store_lanes(efforts.values, Simd4d{});
    for (int first = 0; first < model.body_count; first += kLanes) {
        CAMBRIAN_TICK_ASSERT(model.mass[first] > 0.0 && model.pivot_inertia[first] > 0.0,
                             "a body has a mass");
        const Simd4d mass = load_lanes(model.mass + first);
        const Simd4d spin = load_lanes(k.spin + first);
        const Simd4d s_x = load_lanes(k.s_x + first);
        const Simd4d s_y = load_lanes(k.s_y + first);
        const Simd4d force_x = load_lanes(loads.force_x + first);
        const Simd4d force_y = load_lanes(loads.force_y + first);
        const Simd4d h_x = mass * s_x;
        const Simd4d h_y = mass * s_y;
        const Simd4d effort = load_lanes(loads.effort + first);
        store_lanes(efforts.values + kLanes - 1 + first, effort);
        const Simd4d torque = load_lanes(loads.torque + first) + (s_x * force_x + s_y * force_y) +
                              revolute_effort<kJoints>(model, effort, first);
        const Simd4d square = spin * spin;
        Simd4d x[kLanes] = {mass, Simd4d{}, Simd4d{}, force_x + square * h_y};
        Simd4d y[kLanes] = {Simd4d{}, mass, Simd4d{}, force_y - square * h_x};
        Simd4d turn[kLanes] = {h_x, h_y, load_lanes(model.pivot_inertia + first), torque};
        Simd4d lever[kLanes] = {load_lanes(k.z_x + first), -load_lanes(k.gamma_x + first),
                                load_lanes(k.z_y + first), -load_lanes(k.gamma_y + first)};
        transpose(x[0], x[1], x[2], x[3]);
        transpose(y[0], y[1], y[2], y[3]);
        transpose(turn[0], turn[1], turn[2], turn[3]);
        transpose(lever[0], lever[1], lever[2], lever[3]);
        for (int lane = 0; lane < kLanes; ++lane)
            inertias[first + lane] = {x[lane], y[lane], turn[lane], lever[lane]};
    }
}

CAMBRIAN_INLINE Lever lever_of(const ArticulatedInertia& child) {
    return {__builtin_shufflevector(Simd4d{}, child.to_parent, 0, 1, 4, 5),
            __builtin_shufflevector(Simd4d{}, child.to_parent, 0, 1, 6, 7)};
}

// Transforms a column to the parent's pivot.
CAMBRIAN_INLINE Simd4d as_parent_sees(const Simd4d& column, const Lever& lever) {
    const Simd4d along_y = __builtin_shufflevector(column, column, 1, 1, 1, 1);
    return column + column[0] * lever.x + along_y * lever.y;
}

// Sets the component `turn` of a column to 0.
CAMBRIAN_INLINE Simd4d without_turn(const Simd4d& column) {
    return masked(column, Simd4i{-1, -1, 0, -1});
}

// Returns the effort of a joint as a column with only a load.
CAMBRIAN_INLINE Simd4d load_of(const Efforts& efforts, int i) {
    return masked(load_lanes(efforts.values + i), Simd4i{0, 0, 0, -1});
}

// Adds the first two columns to the parent, their part of the third, and the reaction to the effort
// of a revolute joint.
CAMBRIAN_INLINE void add_to_parent(const Simd4d& x, const Simd4d& y, const Lever& lever,
                                   const Simd4d& effort, ArticulatedInertia& parent) {
    const Simd4d seen_x = as_parent_sees(x, lever);
    const Simd4d seen_y = as_parent_sees(y, lever);
    parent.x += seen_x;
    parent.y += seen_y;
    parent.turn += lever.x[2] * seen_x + lever.y[2] * seen_y - effort;
}

// Both eliminate a joint (planar/README.md 4): they return u and add to the parent the
// articulated inertia minus w w'/d. A revolute joint has w = h, and d = j + g with the damping g of
// an implicit motor; the share g/d of its row goes to the parent.
template <Motors kMotors>
CAMBRIAN_INLINE double eliminate_revolute(const Simd4d& effort, int i, const ArticulatedInertia& c,
                                          const Lever& lever, Factors& factors,
                                          ArticulatedInertia& parent) {
    const Simd4d row = c.turn;
    const double damping = kMotors == Motors::kImplicit ? factors.damping[i] : 0.0;
    const double inverse_d = 1.0 / (kMotors == Motors::kImplicit ? row[2] + damping : row[2]);
    const Simd4d scaled = row * inverse_d;
    Simd4d x = without_turn(c.x - scaled * row[0]);
    Simd4d y = without_turn(c.y - scaled * row[1]);
    if constexpr (kMotors == Motors::kImplicit) {
        const Simd4d left = damping * scaled;
        x[2] = left[0];
        y[2] = left[1];
        parent.turn += as_parent_sees(left, lever);
    }
    add_to_parent(x, y, lever, effort, parent);
    factors.w_x[i] = row[0];
    factors.w_y[i] = row[1];
    factors.inverse_d[i] = inverse_d;
    return row[3];
}

// With the axis n the row is (n A, n h), the load n f + F, and d = n A n + g.
template <Motors kMotors>
CAMBRIAN_INLINE double eliminate_prismatic(const Kinematics& k, double effort, int i,
                                           const ArticulatedInertia& c, const Lever& lever,
                                           Factors& factors, ArticulatedInertia& parent) {
    const double n_x = k.axis_x[i];
    const double n_y = k.axis_y[i];
    Simd4d x = c.x;
    Simd4d y = c.y;
    x[2] = c.turn[0];
    y[2] = c.turn[1];
    Simd4d row = n_x * x + n_y * y;
    row[3] += effort;
    const double along = n_x * row[0] + n_y * row[1];
    const double inverse_d =
        1.0 / (kMotors == Motors::kImplicit ? along + factors.damping[i] : along);
    const Simd4d scaled = row * inverse_d;
    x -= scaled * row[0];
    y -= scaled * row[1];
    const Simd4d turn = c.turn - scaled * row[2];
    add_to_parent(x, y, lever, Simd4d{}, parent);
    parent.turn += as_parent_sees(turn, lever);
    factors.w_x[i] = row[0];
    factors.w_y[i] = row[1];
    factors.w_3[i] = row[2];
    factors.inverse_d[i] = inverse_d;
    return row[3];
}

template <Joints kJoints>
CAMBRIAN_INLINE bool slides(const PlanarModel& model, int i) {
    return kJoints == Joints::kAny && model.motion[i] == JointMotion::kSlide;
}

// Computes a body's response from its parent's; gamma is 0 for impulses.
template <Load kLoad, Motors kMotors, Joints kJoints>
CAMBRIAN_INLINE void follow_parent(const PlanarModel& model, const Kinematics& k,
                                   const Factors& factors, const double* u, int i,
                                   BodyResponse& response) {
    const int p = model.parent[i];
    const double spin = response.spin[p];
    CAMBRIAN_TICK_ASSERT(p >= 0 && p < i, "a parent comes before its children");
    double x = response.x[p] + spin * k.z_x[i];
    double y = response.y[p] + spin * k.z_y[i];
    if constexpr (kLoad == Load::kForce) {
        x += k.gamma_x[i];
        y += k.gamma_y[i];
    }
    double rest = u[i] - factors.w_x[i] * x - factors.w_y[i] * y;
    if (slides<kJoints>(model, i)) {
        rest -= factors.w_3[i] * spin;
        const double slide = rest * factors.inverse_d[i];
        response.x[i] = x + slide * k.axis_x[i];
        response.y[i] = y + slide * k.axis_y[i];
        response.spin[i] = spin;
        response.coordinate[i] = slide;
        return;
    }
    if constexpr (kMotors == Motors::kImplicit) rest += factors.damping[i] * spin;
    const double turn = rest * factors.inverse_d[i];
    response.x[i] = x;
    response.y[i] = y;
    response.spin[i] = turn;
    response.coordinate[i] = turn;
}

// Moves the responses from pivots to centres: a_pivot + alpha s + w^2 perp(s), the last for forces.
template <Load kLoad>
CAMBRIAN_INLINE void move_to_centers(const PlanarModel& model, const Kinematics& k,
                                     BodyResponse& response) {
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d s_x = load_lanes(k.s_x + i);
        const Simd4d s_y = load_lanes(k.s_y + i);
        const Simd4d turn = load_lanes(response.spin + i);
        Simd4d x = load_lanes(response.x + i) + turn * s_x;
        Simd4d y = load_lanes(response.y + i) + turn * s_y;
        if constexpr (kLoad == Load::kForce) {
            const Simd4d spin = load_lanes(k.spin + i);
            x -= spin * spin * s_y;
            y += spin * spin * s_x;
        }
        store_lanes(response.x + i, x);
        store_lanes(response.y + i, y);
    }
}

template <Motors kMotors, Joints kJoints>
CAMBRIAN_INLINE void solve(const PlanarModel& model, const Kinematics& kinematics,
                           const Loads& loads, Factors& factors, BodyResponse& response) {
    ArticulatedInertia inertias[kMaxBodies];
    Efforts efforts;
    PerBody u;
    load_bodies<kJoints>(model, kinematics, loads, inertias, efforts);
    for (int at = model.body_count - 1; at >= model.tree_count; --at) {
        const int i = model.by_depth[at];
        CAMBRIAN_TICK_ASSERT(model.parent[i] >= 0 && model.parent[i] < i, "not a root");
        ArticulatedInertia& parent = inertias[model.parent[i]];
        const Lever lever = lever_of(inertias[i]);
        u[i] = slides<kJoints>(model, i)
                   ? eliminate_prismatic<kMotors>(kinematics, loads.effort[i], i, inertias[i],
                                                  lever, factors, parent)
                   : eliminate_revolute<kMotors>(load_of(efforts, i), i, inertias[i], lever,
                                                 factors, parent);
    }
    for (int tree = 0; tree < model.tree_count; ++tree) {
        const int root = model.tree_begin[tree];
        const int end = model.tree_begin[tree + 1];
        const ArticulatedInertia& all = inertias[root];
        factors.root[tree] =
            invert_inertia(all.x[0], all.x[1], all.y[1], all.turn[0], all.turn[1], all.turn[2]);
        solve_root(factors.root[tree], root, Simd2d{all.x[3], all.y[3]}, all.turn[3], response);
        for (int i = root + 1; i < end; ++i)
            follow_parent<Load::kForce, kMotors, kJoints>(model, kinematics, factors, u, i,
                                                          response);
    }
    move_to_centers<Load::kForce>(model, kinematics, response);
    move_centers(model, loads, response.coordinate);
}

}  // namespace

void solve_accelerations(const PlanarModel& model, const Kinematics& kinematics, const Loads& loads,
                         Factors& factors, BodyResponse& response) {
    for (int i = 0; i < model.body_count; i += kLanes)
        store_lanes(factors.damping + i, Simd4d{});
    if (model.stretch_count > 0)
        return solve_stretched_accelerations(model, kinematics, loads, factors, response);
    if (model.has_slides)
        solve<Motors::kExplicit, Joints::kAny>(model, kinematics, loads, factors, response);
    else
        solve<Motors::kExplicit, Joints::kRevolute>(model, kinematics, loads, factors, response);
}

void solve_damped_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                                const Loads& loads, const PerBody& damping, Factors& factors,
                                BodyResponse& response) {
    for (int i = 0; i < model.body_count; i += kLanes)
        store_lanes(factors.damping + i, load_lanes(damping + i));
    if (model.stretch_count > 0)
        return solve_stretched_accelerations(model, kinematics, loads, factors, response);
    if (model.has_slides)
        solve<Motors::kImplicit, Joints::kAny>(model, kinematics, loads, factors, response);
    else
        solve<Motors::kImplicit, Joints::kRevolute>(model, kinematics, loads, factors, response);
}

void factorize(const PlanarModel& model, const Kinematics& kinematics, Factors& factors) {
    Loads none;
    BodyResponse unused;
    clear_loads(model, none);
    solve_accelerations(model, kinematics, none, factors, unused);
}

namespace {

template <Joints kJoints>
CAMBRIAN_INLINE void solve_impulse_of(const PlanarModel& model, const Kinematics& k,
                                      const Factors& factors, const Loads& impulses,
                                      BodyResponse& response) {
    Simd2d f[kMaxBodies];
    PerBody t;
    PerBody u;
    for (int i = 0; i < model.body_count; ++i) {
        f[i] = Simd2d{impulses.force_x[i], impulses.force_y[i]};
        t[i] = impulses.torque[i] + dot(Simd2d{k.s_x[i], k.s_y[i]}, f[i]);
    }
    for (int tree = model.tree_count - 1; tree >= 0; --tree) {
        const int root = model.tree_begin[tree];
        const int end = model.tree_begin[tree + 1];
        for (int i = end - 1; i > root; --i) {
            const int p = model.parent[i];
            const double effort = impulses.effort[i];
            CAMBRIAN_TICK_ASSERT(p >= 0 && p < i, "a parent comes before its children");
            const bool is_prismatic = slides<kJoints>(model, i);
            const Simd2d w = {factors.w_x[i], factors.w_y[i]};
            u[i] = effort + (is_prismatic ? dot(Simd2d{k.axis_x[i], k.axis_y[i]}, f[i]) : t[i]);
            const double share = u[i] * factors.inverse_d[i];
            const Simd2d passed = f[i] - w * both(share);
            f[p] += passed;
            t[p] += dot(Simd2d{k.z_x[i], k.z_y[i]}, passed) +
                    (is_prismatic ? t[i] - factors.w_3[i] * share
                                  : factors.damping[i] * share - effort);
        }
        solve_root(factors.root[tree], root, f[root], t[root], response);
        for (int i = root + 1; i < end; ++i)
            follow_parent<Load::kImpulse, Motors::kImplicit, kJoints>(model, k, factors, u, i,
                                                                      response);
    }
    move_to_centers<Load::kImpulse>(model, k, response);
    move_centers(model, impulses, response.coordinate);
}

}  // namespace

void solve_impulse(const PlanarModel& model, const Kinematics& k, const Factors& factors,
                   const Loads& impulses, BodyResponse& response) {
    if (model.stretch_count > 0)
        return solve_stretched_impulse(model, k, factors, impulses, response);
    if (model.has_slides)
        solve_impulse_of<Joints::kAny>(model, k, factors, impulses, response);
    else
        solve_impulse_of<Joints::kRevolute>(model, k, factors, impulses, response);
}

void clear_loads(const PlanarModel& model, Loads& loads) {
    for (int i = 0; i < model.body_count; i += kLanes) {
        store_lanes(loads.force_x + i, Simd4d{});
        store_lanes(loads.force_y + i, Simd4d{});
        store_lanes(loads.torque + i, Simd4d{});
        store_lanes(loads.effort + i, Simd4d{});
    }
}

}  // namespace cambrian
