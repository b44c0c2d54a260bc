#pragma once

// The articulated body algorithm (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter
// 7): accelerations of trees of bodies in O(n), and responses to impulses (dynamics/README.md 4).

#include "dynamics/model/kinematics.h"

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

}  // namespace cambrian
