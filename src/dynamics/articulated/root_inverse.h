#pragma once

// The root of a tree: its articulated inertia [[A, h], [h', j]] is inverted by cofactors.

#include "dynamics/articulated/articulated_body.h"

namespace cambrian {

CAMBRIAN_INLINE RootInverse invert_inertia(double xx, double xy, double yy, double xt, double yt,
                                           double tt) {
    const double cofactor_xx = yy * tt - yt * yt;
    const double cofactor_xy = xt * yt - xy * tt;
    const double cofactor_xt = xy * yt - yy * xt;
    const double inverse = 1.0 / (xx * cofactor_xx + xy * cofactor_xy + xt * cofactor_xt);
    return {cofactor_xx * inverse, cofactor_xy * inverse,         (xx * tt - xt * xt) * inverse,
            cofactor_xt * inverse, (xy * xt - xx * yt) * inverse, (xx * yy - xy * xy) * inverse};
}

// Solves for the acceleration or velocity jump of a root's pivot.
CAMBRIAN_INLINE void solve_root(const RootInverse& inverse, int root, const Simd2d& f, double t,
                                BodyResponse& response) {
    response.x[root] = inverse.xx * f[0] + inverse.xy * f[1] + inverse.xt * t;
    response.y[root] = inverse.xy * f[0] + inverse.yy * f[1] + inverse.yt * t;
    response.spin[root] = inverse.xt * f[0] + inverse.yt * f[1] + inverse.tt * t;
    response.coordinate[root] = response.spin[root];
}

// Computes the accelerations or velocity jumps of the trees' centres of mass from the external
// forces or impulses.
CAMBRIAN_INLINE void move_centers(const PlanarModel& model, const Loads& loads,
                                  PerCoordinate& coordinate) {
    const int slots = round_up_to_lanes(model.body_count);
    for (int t = 0; t < model.tree_count; ++t) {
        const double* members = model.members_of(t).membership;
        const double share = 1.0 / model.tree_mass[t];
        const Simd4dVector forces = weighted_sums(members, loads.force_x, loads.force_y, slots);
        coordinate[center_of(model, t)] = share * sum_of(forces.x);
        coordinate[center_of(model, t) + 1] = share * sum_of(forces.y);
    }
}

}  // namespace cambrian
