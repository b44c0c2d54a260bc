#include "dynamics/elimination.h"

namespace cambrian {
namespace {

// Inertia and load a body carries for its subtree, about its pivot: the symmetric matrix
// [[A, h], [h', j]] with A by columns, and (f, t).
struct Carried {
    Pair column_x, column_y, h, f;
    double j, t;
};

CAMBRIAN_INLINE Pair pair_of(const Lanes& x, const Lanes& y, int lane) {
    return Pair{x[lane], y[lane]};
}

// Own inertia and load: h = m s, f less the pull of the centre towards the pivot, t about the
// pivot.
CAMBRIAN_INLINE void load_bodies(const PlanarModel& model, const Kinematics& k, const Loads& loads,
                                 Carried* carried) {
    for (int first = 0; first < model.body_count; first += kLanes) {
        const Lanes mass = load_lanes(model.mass + first);
        const Lanes spin = load_lanes(k.spin + first);
        const Lanes s_x = load_lanes(k.s_x + first);
        const Lanes s_y = load_lanes(k.s_y + first);
        const Lanes force_x = load_lanes(loads.force_x + first);
        const Lanes force_y = load_lanes(loads.force_y + first);
        const Lanes h_x = mass * s_x;
        const Lanes h_y = mass * s_y;
        const Lanes square = spin * spin;
        const Lanes f_x = force_x + square * h_y;
        const Lanes f_y = force_y - square * h_x;
        const Lanes t = load_lanes(loads.torque + first) + (s_x * force_x + s_y * force_y);
        const Lanes j = load_lanes(model.pivot_inertia + first);
        for (int lane = 0; lane < kLanes; ++lane) {
            Carried& c = carried[first + lane];
            c.column_x = Pair{mass[lane], 0.0};
            c.column_y = Pair{0.0, mass[lane]};
            c.h = pair_of(h_x, h_y, lane);
            c.f = pair_of(f_x, f_y, lane);
            c.j = j[lane];
            c.t = t[lane];
        }
    }
}

// Both return u. With u = t + tau: K = A - h h'/j, pi = f - h u/j - K gamma;
// parent: A += K, h += K z, j += z K z, f += pi, t += z pi - tau.
CAMBRIAN_INLINE double eliminate_rotary(const Kinematics& k, double effort, int i, const Carried& c,
                                        Factors& factors, Carried& parent) {
    const Pair z = {k.z_x[i], k.z_y[i]};
    const double inverse_d = 1.0 / c.j;
    const double u = c.t + effort;
    const Pair scaled = c.h * both(inverse_d);
    const Pair left_x = c.column_x - scaled * both(c.h[0]);
    const Pair left_y = c.column_y - scaled * both(c.h[1]);
    const Pair pi =
        c.f - scaled * both(u) - (left_x * both(k.gamma_x[i]) + left_y * both(k.gamma_y[i]));
    const Pair left_z = left_x * both(z[0]) + left_y * both(z[1]);
    factors.w_x[i] = c.h[0];
    factors.w_y[i] = c.h[1];
    factors.inverse_d[i] = inverse_d;
    parent.column_x += left_x;
    parent.column_y += left_y;
    parent.h += left_z;
    parent.j += dot(z, left_z);
    parent.f += pi;
    parent.t += dot(z, pi) - effort;
    return u;
}

// With n the joint's axis: w = A n, w3 = h n, d = n w, u = n f + F, K = A - w w'/d, k = h - w w3/d,
// kappa = j - w3^2/d, pi = f - w u/d - K gamma, pi_t = t - w3 u/d - k gamma;
// parent: A += K, h += K z + k, j += z K z + 2 z k + kappa, f += pi, t += z pi + pi_t.
CAMBRIAN_INLINE double eliminate_linear(const Kinematics& k, double effort, int i, const Carried& c,
                                        Factors& factors, Carried& parent) {
    const Pair n = {k.axis_x[i], k.axis_y[i]};
    const Pair z = {k.z_x[i], k.z_y[i]};
    const Pair gamma = {k.gamma_x[i], k.gamma_y[i]};
    const Pair w = c.column_x * both(n[0]) + c.column_y * both(n[1]);
    const double w_3 = dot(c.h, n);
    const double inverse_d = 1.0 / dot(n, w);
    const double u = dot(n, c.f) + effort;
    const Pair scaled = w * both(inverse_d);
    const Pair left_x = c.column_x - scaled * both(w[0]);
    const Pair left_y = c.column_y - scaled * both(w[1]);
    const Pair left_h = c.h - scaled * both(w_3);
    const double kappa = c.j - w_3 * w_3 * inverse_d;
    const Pair pi = c.f - scaled * both(u) - (left_x * both(gamma[0]) + left_y * both(gamma[1]));
    const double pi_t = c.t - w_3 * (u * inverse_d) - dot(left_h, gamma);
    const Pair left_z = left_x * both(z[0]) + left_y * both(z[1]);
    factors.w_x[i] = w[0];
    factors.w_y[i] = w[1];
    factors.w_3[i] = w_3;
    factors.inverse_d[i] = inverse_d;
    parent.column_x += left_x;
    parent.column_y += left_y;
    parent.h += left_z + left_h;
    parent.j += dot(z, left_z) + 2.0 * dot(z, left_h) + kappa;
    parent.f += pi;
    parent.t += dot(z, pi) + pi_t;
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

// Accelerations or velocity jumps of the pivots; x and y are the response's, which hold the pivots'
// until move_to_centers.
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
    if constexpr (kLoad == Load::kForce) {
        x += k.gamma_x[i];
        y += k.gamma_y[i];
    }
    double rest = u[i] - factors.w_x[i] * x - factors.w_y[i] * y;
    if (model.joint[i] == JointType::kLinear) {
        rest -= factors.w_3[i] * spin;
        const double slide = rest * factors.inverse_d[i];
        response.x[i] = x + slide * k.axis_x[i];
        response.y[i] = y + slide * k.axis_y[i];
        response.spin[i] = spin;
        response.coordinate[i] = slide;
        return;
    }
    const double turn = rest * factors.inverse_d[i];
    response.x[i] = x;
    response.y[i] = y;
    response.spin[i] = turn;
    response.coordinate[i] = turn;
}

// a = a_pivot + alpha s, and - w^2 perp(s) under forces.
template <Load kLoad>
CAMBRIAN_INLINE void move_to_centers(const PlanarModel& model, const Kinematics& k,
                                     BodyResponse& response) {
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Lanes s_x = load_lanes(k.s_x + i);
        const Lanes s_y = load_lanes(k.s_y + i);
        const Lanes turn = load_lanes(response.spin + i);
        Lanes x = load_lanes(response.x + i) + turn * s_x;
        Lanes y = load_lanes(response.y + i) + turn * s_y;
        if constexpr (kLoad == Load::kForce) {
            const Lanes spin = load_lanes(k.spin + i);
            x -= spin * spin * s_y;
            y += spin * spin * s_x;
        }
        store_lanes(response.x + i, x);
        store_lanes(response.y + i, y);
    }
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

void solve_accelerations(const PlanarModel& model, const Kinematics& kinematics, const Loads& loads,
                         Factors& factors, BodyResponse& response) {
    Carried carried[kMaxBodies];
    PerBody u;
    load_bodies(model, kinematics, loads, carried);
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
    move_to_centers<Load::kForce>(model, kinematics, response);
    move_centers(model, loads, response);
}

void solve_impulse(const PlanarModel& model, const Kinematics& k, const Factors& factors,
                   const Loads& impulses, BodyResponse& response) {
    Pair f[kMaxBodies];
    PerBody t;
    PerBody u;
    for (int i = 0; i < model.body_count; ++i) {
        f[i] = Pair{impulses.force_x[i], impulses.force_y[i]};
        t[i] = impulses.torque[i] + dot(Pair{k.s_x[i], k.s_y[i]}, f[i]);
    }
    for (int tree = model.tree_count - 1; tree >= 0; --tree) {
        const int root = model.tree_begin[tree];
        const int end = model.tree_begin[tree + 1];
        for (int i = end - 1; i > root; --i) {
            const int p = model.parent[i];
            const double effort = impulses.effort[i];
            const bool linear = model.joint[i] == JointType::kLinear;
            const Pair w = {factors.w_x[i], factors.w_y[i]};
            u[i] = effort + (linear ? dot(Pair{k.axis_x[i], k.axis_y[i]}, f[i]) : t[i]);
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
    move_to_centers<Load::kImpulse>(model, k, response);
    move_centers(model, impulses, response);
}

void clear_loads(const PlanarModel& model, Loads& loads) {
    for (int i = 0; i < model.body_count; i += kLanes) {
        store_lanes(loads.force_x + i, Lanes{});
        store_lanes(loads.force_y + i, Lanes{});
        store_lanes(loads.torque + i, Lanes{});
        store_lanes(loads.effort + i, Lanes{});
    }
}

}  // namespace cambrian
