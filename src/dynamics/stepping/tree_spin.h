#pragma once

// The rotation of a tree about its centre of mass, and its correction (dynamics/README.md 17).

#include "dynamics/model/kinematics.h"

namespace cambrian {

struct TreeSpin {
    double momentum = 0.0;  // kg m^2/s, angular, about the tree's centre of mass
    double inertia = 0.0;   // kg m^2, about that centre
};

// Places and velocities of the kinematics must be those of the motion.
TreeSpin spin_of_tree(const PlanarModel& model, const Motion& motion, const Kinematics& kinematics,
                      int tree);

// Returns the sum of the absolute angular momenta of the tree's bodies about its centre of mass,
// orbital and own, kg m^2/s.
double gross_spin_of_tree(const PlanarModel& model, const Motion& motion,
                          const Kinematics& kinematics, int tree);

// Turns the tree about its centre of mass such that its angular momentum there is that of `before`
// and what was `given`, kg m^2/s. Joints do not move. Returns the kinetic energy of all bodies
// afterwards, J.
double restore_spin(const PlanarModel& model, int tree, double before, double given, Motion& motion,
                    Kinematics& kinematics);

}  // namespace cambrian
