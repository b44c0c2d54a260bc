#pragma once

// The constraint-force equation of trees of joints, solved exactly in O(n) by eliminating the
// bodies from the leaves to the roots (physics.md 4.2, 4.3).

#include "dynamics/model/kinematics.h"

namespace cambrian {

// Explicit forces (never constraint forces) on the bodies, or impulses; and joint efforts, which
// act on the child and back on its parent.
struct Loads {
    PerBody force_x, force_y;  // N, at the centre of mass
    PerBody torque;            // N m
    PerBody effort;            // N m or N, along the joint's coordinate
};

// Inverse of the symmetric inertia a root carries for its tree.
struct RootInverse {
    double xx, xy, yy, xt, yt, tt;
};

// Factorisation of a moment's equation, good for any load.
struct Factors {
    PerBody w_x, w_y, w_3, inverse_d;
    PerBody damping;  // effort that a rotary joint loses per acceleration; 0 if explicit
    RootInverse root[kMaxTrees];
};

// Accelerations, or velocity jumps, of every body and joint.
struct BodyResponse {
    PerBody x, y, spin;
    PerCoordinate coordinate;
};

// Accelerations under the loads; leaves the factors behind for solve_impulse.
void solve_accelerations(const PlanarModel& model, const Kinematics& kinematics, const Loads& loads,
                         Factors& factors, BodyResponse& response);

// The same where every joint's effort falls by a damping times the joint's acceleration, as motors
// do in an implicit stage. Solves of impulses with these factors feel it too. 0 on roots.
void solve_damped_accelerations(const PlanarModel& model, const Kinematics& kinematics,
                                const Loads& loads, const PerBody& damping, Factors& factors,
                                BodyResponse& response);

// The factors alone.
void factorize(const PlanarModel& model, const Kinematics& kinematics, Factors& factors);

// Velocity jumps under the loads taken as impulses.
void solve_impulse(const PlanarModel& model, const Kinematics& kinematics, const Factors& factors,
                   const Loads& impulses, BodyResponse& response);

void clear_loads(const PlanarModel& model, Loads& loads);

}  // namespace cambrian
