#pragma once

// Angular momenta of trees that nothing outside touches, and their correction (planar/README.md
// 17).

#include "planar/stepping/step_control.h"

#include <optional>

namespace cambrian {

// Returns the trees that a contact or a force pushes from outside, by the bits of their roots.
template <class Pushing>
BodySet touched_trees(const PlanarModel& model, const Pushing& pushing) {
    const BodySet first = model.root_path[pushing.body_a] & model.roots;
    const BodySet second = pushing.body_b < 0 ? 0 : model.root_path[pushing.body_b] & model.roots;
    return first == second ? 0 : first | second;
}

// Returns the trees on which nothing acted in a step but what kSpinGiven measures.
BodySet free_trees(const PlanarModel& model, const Forcing& forcing, const HeldForces& held);

// Turns free trees at the end of the tick's last step such that their angular momenta have changed
// by what was given to them. This undoes the errors of integration, by which a creature could spin
// itself up. Returns the mechanical energy there (J), if it was changed.
std::optional<double> restore_spins(const PlanarModel& model, const Medium& medium, BodySet free,
                                    bool is_last, SimulationState& state, Motion& end,
                                    Kinematics& end_kinematics);

// Notes in the audit what the angular momenta of free trees have gained in spite of that.
void check_spins(const PlanarModel& model, SimulationState& state);

struct TreeSpin {
    double momentum = 0.0;  // kg m^2/s, angular, about the tree's centre of mass
    double inertia = 0.0;   // kg m^2, about that centre
};

// Places and velocities of the kinematics must be those of the motion.
TreeSpin spin_of_tree(const PlanarModel& model, const Motion& motion, const Kinematics& kinematics,
                      int tree);

// Turns the tree about its centre of mass such that its angular momentum there is that of `before`
// and what was `given`, kg m^2/s. Joints do not move. Returns the kinetic energy of all bodies
// afterwards, J.
double restore_spin(const PlanarModel& model, int tree, double before, double given, Motion& motion,
                    Kinematics& kinematics);

}  // namespace cambrian
