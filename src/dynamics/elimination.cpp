#include "dynamics/elimination.h"

namespace cambrian {
namespace {

// Inertia and load every body carries for its subtree, about its centre of mass: the symmetric
// matrix [[A, h], [h', j]] and (f, t).
struct Carried {
    PerBody xx, xy, yy, h_x, h_y, j;
    PerBody f_x, f_y, t;
    PerBody u;
};

void load_bodies(const PlanarModel& model, const Loads& loads, Carried& c) {
    for (int i = 0; i < model.body_count; ++i) {
        c.xx[i] = model.mass[i];
        c.xy[i] = 0.0;
        c.yy[i] = model.mass[i];
        c.h_x[i] = 0.0;
        c.h_y[i] = 0.0;
        c.j[i] = model.inertia[i];
        c.f_x[i] = loads.force_x[i];
        c.f_y[i] = loads.force_y[i];
        c.t[i] = loads.torque[i];
    }
}

// w = h + A s,  d = j + (h + w) s,  u = s f + t + tau - w gamma,
// K = A - w w'/d,  pi = A gamma + w u/d - f;
// parent: A += K, h += K z, j += z K z, f -= pi, t -= z pi + tau.
inline void eliminate_rotary(const Kinematics& k, double effort, Factors& factors, Carried& c,
                             int i, int p) {
    const double s_x = k.s_x[i];
    const double s_y = k.s_y[i];
    const double z_x = k.z_x[i];
    const double z_y = k.z_y[i];
    const double w_x = c.h_x[i] + c.xx[i] * s_x + c.xy[i] * s_y;
    const double w_y = c.h_y[i] + c.xy[i] * s_x + c.yy[i] * s_y;
    const double d = c.j[i] + (c.h_x[i] + w_x) * s_x + (c.h_y[i] + w_y) * s_y;
    const double inverse_d = 1.0 / d;
    const double u =
        s_x * c.f_x[i] + s_y * c.f_y[i] + c.t[i] + effort - w_x * k.gamma_x[i] - w_y * k.gamma_y[i];
    const double k_xx = c.xx[i] - w_x * w_x * inverse_d;
    const double k_xy = c.xy[i] - w_x * w_y * inverse_d;
    const double k_yy = c.yy[i] - w_y * w_y * inverse_d;
    const double share = u * inverse_d;
    const double pi_x = c.xx[i] * k.gamma_x[i] + c.xy[i] * k.gamma_y[i] + w_x * share - c.f_x[i];
    const double pi_y = c.xy[i] * k.gamma_x[i] + c.yy[i] * k.gamma_y[i] + w_y * share - c.f_y[i];
    const double kz_x = k_xx * z_x + k_xy * z_y;
    const double kz_y = k_xy * z_x + k_yy * z_y;
    factors.w_x[i] = w_x;
    factors.w_y[i] = w_y;
    factors.inverse_d[i] = inverse_d;
    c.u[i] = u;
    c.xx[p] += k_xx;
    c.xy[p] += k_xy;
    c.yy[p] += k_yy;
    c.h_x[p] += kz_x;
    c.h_y[p] += kz_y;
    c.j[p] += z_x * kz_x + z_y * kz_y;
    c.f_x[p] -= pi_x;
    c.f_y[p] -= pi_y;
    c.t[p] -= z_x * pi_x + z_y * pi_y + effort;
}

// With s the joint's axis: w = A s, w3 = h s, d = s w, u = s f + F - w gamma,
// K = A - w w'/d, k = h - w w3/d, kappa = j - w3^2/d, pi_t = h gamma + w3 u/d - t;
// parent: A += K, h += K z + k, j += z K z + 2 z k + kappa, f -= pi, t -= z pi + pi_t.
inline void eliminate_linear(const Kinematics& k, double effort, Factors& factors, Carried& c,
                             int i, int p) {
    const double s_x = k.s_x[i];
    const double s_y = k.s_y[i];
    const double z_x = k.z_x[i];
    const double z_y = k.z_y[i];
    const double w_x = c.xx[i] * s_x + c.xy[i] * s_y;
    const double w_y = c.xy[i] * s_x + c.yy[i] * s_y;
    const double w_3 = c.h_x[i] * s_x + c.h_y[i] * s_y;
    const double inverse_d = 1.0 / (s_x * w_x + s_y * w_y);
    const double u =
        s_x * c.f_x[i] + s_y * c.f_y[i] + effort - w_x * k.gamma_x[i] - w_y * k.gamma_y[i];
    const double k_xx = c.xx[i] - w_x * w_x * inverse_d;
    const double k_xy = c.xy[i] - w_x * w_y * inverse_d;
    const double k_yy = c.yy[i] - w_y * w_y * inverse_d;
    const double k_x = c.h_x[i] - w_x * w_3 * inverse_d;
    const double k_y = c.h_y[i] - w_y * w_3 * inverse_d;
    const double kappa = c.j[i] - w_3 * w_3 * inverse_d;
    const double share = u * inverse_d;
    const double pi_x = c.xx[i] * k.gamma_x[i] + c.xy[i] * k.gamma_y[i] + w_x * share - c.f_x[i];
    const double pi_y = c.xy[i] * k.gamma_x[i] + c.yy[i] * k.gamma_y[i] + w_y * share - c.f_y[i];
    const double pi_t = c.h_x[i] * k.gamma_x[i] + c.h_y[i] * k.gamma_y[i] + w_3 * share - c.t[i];
    const double kz_x = k_xx * z_x + k_xy * z_y;
    const double kz_y = k_xy * z_x + k_yy * z_y;
    factors.w_x[i] = w_x;
    factors.w_y[i] = w_y;
    factors.w_3[i] = w_3;
    factors.inverse_d[i] = inverse_d;
    c.u[i] = u;
    c.xx[p] += k_xx;
    c.xy[p] += k_xy;
    c.yy[p] += k_yy;
    c.h_x[p] += kz_x + k_x;
    c.h_y[p] += kz_y + k_y;
    c.j[p] += z_x * kz_x + z_y * kz_y + 2.0 * (z_x * k_x + z_y * k_y) + kappa;
    c.f_x[p] -= pi_x;
    c.f_y[p] -= pi_y;
    c.t[p] -= z_x * pi_x + z_y * pi_y + pi_t;
}

// Inverse of the root's symmetric 3x3 inertia by cofactors.
void invert_root(const Carried& c, Factors& factors) {
    const double xx = c.xx[0];
    const double xy = c.xy[0];
    const double yy = c.yy[0];
    const double xt = c.h_x[0];
    const double yt = c.h_y[0];
    const double tt = c.j[0];
    const double cofactor_xx = yy * tt - yt * yt;
    const double cofactor_xy = xt * yt - xy * tt;
    const double cofactor_xt = xy * yt - yy * xt;
    const double inverse = 1.0 / (xx * cofactor_xx + xy * cofactor_xy + xt * cofactor_xt);
    factors.root_xx = cofactor_xx * inverse;
    factors.root_xy = cofactor_xy * inverse;
    factors.root_xt = cofactor_xt * inverse;
    factors.root_yy = (xx * tt - xt * xt) * inverse;
    factors.root_yt = (xy * xt - xx * yt) * inverse;
    factors.root_tt = (xx * yy - xy * xy) * inverse;
}

inline void solve_root(const Factors& factors, double f_x, double f_y, double t,
                       BodyResponse& response) {
    response.x[0] = factors.root_xx * f_x + factors.root_xy * f_y + factors.root_xt * t;
    response.y[0] = factors.root_xy * f_x + factors.root_yy * f_y + factors.root_yt * t;
    response.spin[0] = factors.root_xt * f_x + factors.root_yt * f_y + factors.root_tt * t;
    response.coordinate[2] = response.spin[0];
}

// Body i's response from its parent's; gamma is 0 for impulses.
inline void follow_parent(const PlanarModel& model, const Kinematics& k, const Factors& factors,
                          const double* u, int i, bool accelerations, BodyResponse& response) {
    const int p = model.parent[i];
    const double spin = response.spin[p];
    double x = response.x[p] + spin * k.z_x[i];
    double y = response.y[p] + spin * k.z_y[i];
    double rest = u[i] - factors.w_x[i] * x - factors.w_y[i] * y;
    const bool linear = model.joint[i] == JointType::kLinear;
    if (linear) rest -= factors.w_3[i] * spin;
    const double coordinate = rest * factors.inverse_d[i];
    if (accelerations) {
        x += k.gamma_x[i];
        y += k.gamma_y[i];
    }
    response.x[i] = x + coordinate * k.s_x[i];
    response.y[i] = y + coordinate * k.s_y[i];
    response.spin[i] = linear ? spin : coordinate;
    response.coordinate[coordinate_of(i)] = coordinate;
}

// The centre of mass feels the explicit forces only.
void move_center(const PlanarModel& model, const Loads& loads, BodyResponse& response) {
    double x = 0.0;
    double y = 0.0;
    for (int i = 0; i < model.body_count; ++i) {
        x += loads.force_x[i];
        y += loads.force_y[i];
    }
    response.coordinate[0] = x / model.total_mass;
    response.coordinate[1] = y / model.total_mass;
}

}  // namespace

void solve_accelerations(const PlanarModel& model, const Kinematics& kinematics, const Loads& loads,
                         Factors& factors, BodyResponse& response) {
    Carried c;
    load_bodies(model, loads, c);
    for (int i = model.body_count - 1; i > 0; --i) {
        if (model.joint[i] == JointType::kLinear)
            eliminate_linear(kinematics, loads.effort[i], factors, c, i, model.parent[i]);
        else
            eliminate_rotary(kinematics, loads.effort[i], factors, c, i, model.parent[i]);
    }
    invert_root(c, factors);
    solve_root(factors, c.f_x[0], c.f_y[0], c.t[0], response);
    for (int i = 1; i < model.body_count; ++i)
        follow_parent(model, kinematics, factors, c.u, i, true, response);
    move_center(model, loads, response);
}

void solve_impulse(const PlanarModel& model, const Kinematics& k, const Factors& factors,
                   const Loads& impulses, BodyResponse& response) {
    PerBody f_x;
    PerBody f_y;
    PerBody t;
    PerBody u;
    for (int i = 0; i < model.body_count; ++i) {
        f_x[i] = impulses.force_x[i];
        f_y[i] = impulses.force_y[i];
        t[i] = impulses.torque[i];
    }
    for (int i = model.body_count - 1; i > 0; --i) {
        const int p = model.parent[i];
        const double effort = impulses.effort[i];
        const bool linear = model.joint[i] == JointType::kLinear;
        u[i] = k.s_x[i] * f_x[i] + k.s_y[i] * f_y[i] + effort + (linear ? 0.0 : t[i]);
        const double share = u[i] * factors.inverse_d[i];
        const double passed_x = f_x[i] - factors.w_x[i] * share;
        const double passed_y = f_y[i] - factors.w_y[i] * share;
        f_x[p] += passed_x;
        f_y[p] += passed_y;
        t[p] += k.z_x[i] * passed_x + k.z_y[i] * passed_y +
                (linear ? t[i] - factors.w_3[i] * share : -effort);
    }
    solve_root(factors, f_x[0], f_y[0], t[0], response);
    for (int i = 1; i < model.body_count; ++i)
        follow_parent(model, k, factors, u, i, false, response);
    move_center(model, impulses, response);
}

void clear_loads(const PlanarModel& model, Loads& loads) {
    for (int i = 0; i < model.body_count; ++i) {
        loads.force_x[i] = 0.0;
        loads.force_y[i] = 0.0;
        loads.torque[i] = 0.0;
        loads.effort[i] = 0.0;
    }
}

}  // namespace cambrian
