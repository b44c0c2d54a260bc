#pragma once

// The articulated body algorithm (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter
// 7): accelerations of trees of bodies in O(n), and responses to impulses (planar/README.md 4).

#include "planar/model/kinematics.h"

namespace cambrian {

// External forces or impulses on the bodies, without constraint forces. An effort of a joint acts
// on the child and back on its parent.
struct Loads {
    PerBody force_x, force_y;  // N, at the centre of mass
    PerBody torque;            // N m
    PerBody effort;            // N m or N, along the joint's coordinate
};

// Inverse of the articulated inertia of a root, which is symmetric.
struct RootInverse {
    double xx, xy, yy, xt, yt, tt;
};

// Factorisation of the equations at one state; it serves all loads.
struct Factors {
    PerBody w_x, w_y, w_3, inverse_d;
    PerBody damping;  // effort that a revolute joint loses per acceleration; 0 if explicit
    RootInverse root[kMaxTrees];
};

// Accelerations, or velocity jumps, of every body and joint.
struct BodyResponse {
    PerBody x, y, spin;
    PerCoordinate coordinate;
};

// Computes the accelerations under the loads, and the factors that solve_impulse needs.
void solve_accelerations(const PlanarModel& model, const Kinematics& kinematics, const Loads& loads,
                         Factors& factors, BodyResponse& response);

// Does the same with efforts that fall by `damping` times the joint's acceleration, as those of
// motors in an implicit stage. The factors include the damping. It is 0 on roots.
void solve_damped_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                                const Loads& loads, const PerBody& damping, Factors& factors,
                                BodyResponse& response);

// Computes the factors alone.
void factorize(const PlanarModel& model, const Kinematics& kinematics, Factors& factors);

// Computes the jumps of the velocities, with the loads as impulses.
void solve_impulse(const PlanarModel& model, const Kinematics& kinematics, const Factors& factors,
                   const Loads& impulses, BodyResponse& response);

void clear_loads(const PlanarModel& model, Loads& loads);

// The root of a tree: its articulated inertia [[A, h], [h', j]] is inverted by cofactors.

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

// The articulated body algorithm for trees with stretches (planar/README.md 20): a deformable
// body eliminates its stretch before its joint is looked at, and what is left is a rigid body to
// the joint. The factors of a stretch's slot are w, w_3 (to the body's spin) and 1/d.

// Does what solve_accelerations does, with the damping that the factors hold.
void solve_stretched_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                                   const Loads& loads, Factors& factors, BodyResponse& response);

// Does what solve_impulse does.
void solve_stretched_impulse(const PlanarModel& model, const Kinematics& kinematics,
                             const Factors& factors, const Loads& impulses, BodyResponse& response);

// Responses to two sets of impulses at once, in the halves of one vector.

// Does what solve_impulse does for each of the two, but fills only the jumps of the coordinates,
// with 0 beyond their count.
void solve_paired_impulses(const PlanarModel& model, const Kinematics& kinematics,
                           const Factors& factors, const Loads (&impulses)[2],
                           PerCoordinate (&jumps)[2]);

// Does the same for impulses that are efforts of joints only.
void solve_paired_efforts(const PlanarModel& model, const Kinematics& kinematics,
                          const Factors& factors, const PerBody (&efforts)[2],
                          PerCoordinate (&jumps)[2]);

}  // namespace cambrian
