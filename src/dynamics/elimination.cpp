#include "dynamics/elimination.h"

namespace cambrian {
namespace {

// Inertia and load a body carries for its subtree, about its centre of mass: the symmetric matrix
// [[A, h], [h', j]] with A by columns, and (f, t).
struct Carried {
    Pair column_x, column_y, h, f;
    double j, t;
};

CAMBRIAN_INLINE void load_bodies(const PlanarModel& model, const Loads& loads, Carried* carried) {
    for (int i = 0; i < model.body_count; ++i) {
        Carried& c = carried[i];
        c.column_x = Pair{model.mass[i], 0.0};
        c.column_y = Pair{0.0, model.mass[i]};
        c.h = Pair{0.0, 0.0};
        c.f = Pair{loads.force_x[i], loads.force_y[i]};
        c.j = model.inertia[i];
        c.t = loads.torque[i];
    }
}

// Both return u. w = h + A s,  d = j + (h + w) s,  u = s f + t + tau - w gamma,
// K = A - w w'/d,  pi = A gamma + w u/d - f;
// parent: A += K, h += K z, j += z K z, f -= pi, t -= z pi + tau.
CAMBRIAN_INLINE double eliminate_rotary(const Kinematics& k, double effort, int i, const Carried& c,
                                        Factors& factors, Carried& parent) {
    const Pair s = {k.s_x[i], k.s_y[i]};
    const Pair z = {k.z_x[i], k.z_y[i]};
    const Pair gamma = {k.gamma_x[i], k.gamma_y[i]};
    const Pair w = c.h + (c.column_x * both(s[0]) + c.column_y * both(s[1]));
    const double inverse_d = 1.0 / (c.j + dot(c.h + w, s));
    const double u = dot(s, c.f) - dot(w, gamma) + (c.t + effort);
    const Pair scaled = w * both(inverse_d);
    const Pair left_x = c.column_x - scaled * both(w[0]);
    const Pair left_y = c.column_y - scaled * both(w[1]);
    const Pair pi =
        c.column_x * both(gamma[0]) + c.column_y * both(gamma[1]) + (scaled * both(u) - c.f);
    const Pair left_z = left_x * both(z[0]) + left_y * both(z[1]);
    factors.w_x[i] = w[0];
    factors.w_y[i] = w[1];
    factors.inverse_d[i] = inverse_d;
    parent.column_x += left_x;
    parent.column_y += left_y;
    parent.h += left_z;
    parent.j += dot(z, left_z);
    parent.f -= pi;
    parent.t -= dot(z, pi) + effort;
    return u;
}

// With s the joint's axis: w = A s, w3 = h s, d = s w, u = s f + F - w gamma,
// K = A - w w'/d, k = h - w w3/d, kappa = j - w3^2/d, pi_t = h gamma + w3 u/d - t;
// parent: A += K, h += K z + k, j += z K z + 2 z k + kappa, f -= pi, t -= z pi + pi_t.
CAMBRIAN_INLINE double eliminate_linear(const Kinematics& k, double effort, int i, const Carried& c,
                                        Factors& factors, Carried& parent) {
    const Pair s = {k.s_x[i], k.s_y[i]};
    const Pair z = {k.z_x[i], k.z_y[i]};
    const Pair gamma = {k.gamma_x[i], k.gamma_y[i]};
    const Pair w = c.column_x * both(s[0]) + c.column_y * both(s[1]);
    const double w_3 = dot(c.h, s);
    const double inverse_d = 1.0 / dot(s, w);
    const double u = dot(s, c.f) - dot(w, gamma) + effort;
    const Pair scaled = w * both(inverse_d);
    const Pair left_x = c.column_x - scaled * both(w[0]);
    const Pair left_y = c.column_y - scaled * both(w[1]);
    const Pair left_h = c.h - scaled * both(w_3);
    const double kappa = c.j - w_3 * w_3 * inverse_d;
    const Pair pi =
        c.column_x * both(gamma[0]) + c.column_y * both(gamma[1]) + (scaled * both(u) - c.f);
    const double pi_t = dot(c.h, gamma) + w_3 * (u * inverse_d) - c.t;
    const Pair left_z = left_x * both(z[0]) + left_y * both(z[1]);
    factors.w_x[i] = w[0];
    factors.w_y[i] = w[1];
    factors.w_3[i] = w_3;
    factors.inverse_d[i] = inverse_d;
    parent.column_x += left_x;
    parent.column_y += left_y;
    parent.h += left_z + left_h;
    parent.j += dot(z, left_z) + 2.0 * dot(z, left_h) + kappa;
    parent.f -= pi;
    parent.t -= dot(z, pi) + pi_t;
    return u;
}

// By cofactors.
CAMBRIAN_INLINE RootInverse invert_root(const Carried& c) {
    const double xx = c.column_x[0];
    const double xy = c.column_x[1];
    const double yy = c.column_y[1];
    const double xt = c.h[0];
    const double yt = c.h[1];
    const double tt = c.j;
    const double cofactor_xx = yy * tt - yt * yt;
    const double cofactor_xy = xt * yt - xy * tt;
    const double cofactor_xt = xy * yt - yy * xt;
    const double inverse = 1.0 / (xx * cofactor_xx + xy * cofactor_xy + xt * cofactor_xt);
    return {cofactor_xx * inverse, cofactor_xy * inverse,         (xx * tt - xt * xt) * inverse,
            cofactor_xt * inverse, (xy * xt - xx * yt) * inverse, (xx * yy - xy * xy) * inverse};
}

CAMBRIAN_INLINE void solve_root(const RootInverse& inverse, int root, const Pair& f, double t,
                                BodyResponse& response) {
    response.x[root] = inverse.xx * f[0] + inverse.xy * f[1] + inverse.xt * t;
    response.y[root] = inverse.xy * f[0] + inverse.yy * f[1] + inverse.yt * t;
    response.spin[root] = inverse.xt * f[0] + inverse.yt * f[1] + inverse.tt * t;
    response.coordinate[root] = response.spin[root];
}

enum class Load { kForce, kImpulse };

// Body i's response from its parent's; gamma is 0 for impulses.
template <Load kLoad>
CAMBRIAN_INLINE void follow_parent(const PlanarModel& model, const Kinematics& k,
                                   const Factors& factors, const double* u, int i,
                                   BodyResponse& response) {
    const int p = model.parent[i];
    const double spin = response.spin[p];
    double x = response.x[p] + spin * k.z_x[i];
    double y = response.y[p] + spin * k.z_y[i];
    double rest = u[i] - factors.w_x[i] * x - factors.w_y[i] * y;
    const bool linear = model.joint[i] == JointType::kLinear;
    if (linear) rest -= factors.w_3[i] * spin;
    const double coordinate = rest * factors.inverse_d[i];
    if constexpr (kLoad == Load::kForce) {
        x += k.gamma_x[i];
        y += k.gamma_y[i];
    }
    response.x[i] = x + coordinate * k.s_x[i];
    response.y[i] = y + coordinate * k.s_y[i];
    response.spin[i] = linear ? spin : coordinate;
    response.coordinate[i] = coordinate;
}

// Centres of mass feel the explicit forces only.
CAMBRIAN_INLINE void move_centers(const PlanarModel& model, const Loads& loads,
                                  BodyResponse& response) {
    const int slots = round_up_to_lanes(model.body_count);
    for (int t = 0; t < model.tree_count; ++t) {
        const double* members = model.membership[t];
        const double share = 1.0 / model.tree_mass[t];
        response.coordinate[center_of(model, t)] =
            share * lane_product(members, loads.force_x, slots);
        response.coordinate[center_of(model, t) + 1] =
            share * lane_product(members, loads.force_y, slots);
    }
}

}  // namespace

CAMBRIAN_WIDE void solve_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                                       const Loads& loads, Factors& factors,
                                       BodyResponse& response) {
    Carried carried[kMaxBodies];
    PerBody u;
    load_bodies(model, loads, carried);
    for (int tree = model.tree_count - 1; tree >= 0; --tree) {
        const int root = model.tree_begin[tree];
        const int end = model.tree_begin[tree + 1];
        for (int i = end - 1; i > root; --i) {
            Carried& parent = carried[model.parent[i]];
            const double effort = loads.effort[i];
            u[i] = model.joint[i] == JointType::kLinear
                       ? eliminate_linear(kinematics, effort, i, carried[i], factors, parent)
                       : eliminate_rotary(kinematics, effort, i, carried[i], factors, parent);
        }
        factors.root[tree] = invert_root(carried[root]);
        solve_root(factors.root[tree], root, carried[root].f, carried[root].t, response);
        for (int i = root + 1; i < end; ++i)
            follow_parent<Load::kForce>(model, kinematics, factors, u, i, response);
    }
    move_centers(model, loads, response);
}

CAMBRIAN_WIDE void solve_impulse(const PlanarModel& model, const Kinematics& k,
                                 const Factors& factors, const Loads& impulses,
                                 BodyResponse& response) {
    Pair f[kMaxBodies];
    PerBody t;
    PerBody u;
    for (int i = 0; i < model.body_count; ++i) {
        f[i] = Pair{impulses.force_x[i], impulses.force_y[i]};
        t[i] = impulses.torque[i];
    }
    for (int tree = model.tree_count - 1; tree >= 0; --tree) {
        const int root = model.tree_begin[tree];
        const int end = model.tree_begin[tree + 1];
        for (int i = end - 1; i > root; --i) {
            const int p = model.parent[i];
            const double effort = impulses.effort[i];
            const bool linear = model.joint[i] == JointType::kLinear;
            const Pair w = {factors.w_x[i], factors.w_y[i]};
            u[i] = dot(Pair{k.s_x[i], k.s_y[i]}, f[i]) + effort + (linear ? 0.0 : t[i]);
            const double share = u[i] * factors.inverse_d[i];
            const Pair passed = f[i] - w * both(share);
            f[p] += passed;
            t[p] += dot(Pair{k.z_x[i], k.z_y[i]}, passed) +
                    (linear ? t[i] - factors.w_3[i] * share : -effort);
        }
        solve_root(factors.root[tree], root, f[root], t[root], response);
        for (int i = root + 1; i < end; ++i)
            follow_parent<Load::kImpulse>(model, k, factors, u, i, response);
    }
    move_centers(model, impulses, response);
}

CAMBRIAN_WIDE void clear_loads(const PlanarModel& model, Loads& loads) {
    for (int i = 0; i < model.body_count; i += kLanes) {
        store_lanes(loads.force_x + i, Lanes{});
        store_lanes(loads.force_y + i, Lanes{});
        store_lanes(loads.torque + i, Lanes{});
        store_lanes(loads.effort + i, Lanes{});
    }
}

}  // namespace cambrian
