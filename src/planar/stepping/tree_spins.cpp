#include "planar/stepping/tree_spins.h"

#include "core/assert.h"
#include "planar/stepping/audit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kScaleSpin = 1e-3;  // rad/s; for the audit of what hardly moves

// Moments of inertia of four bodies about their centres; 0 in the slots of stretches.
CAMBRIAN_INLINE Simd4d inertia_lanes(const PlanarModel& model, const Kinematics& k, int first) {
    if (!k.deforms) return load_lanes(model.inertia + first);
    double inertias[kLanes] = {};
    for (int lane = 0; lane < kLanes && first + lane < model.body_count; ++lane)
        inertias[lane] = present_inertia(model, k, first + lane);
    return load_lanes(inertias);
}

// Calls visit(mass, offset, velocity, inertia, spin) for four bodies of a tree at once; masses and
// inertias of other slots are 0, offsets are from the tree's centre.
template <class Visit>
CAMBRIAN_INLINE void visit_bodies(const PlanarModel& model, const Motion& motion,
                                  const Kinematics& k, int tree, const Visit& visit) {
    const double* membership = model.members_of(tree).membership;
    const int center = center_of(model, tree);
    const Simd4d center_x = all_lanes(motion.position[center]);
    const Simd4d center_y = all_lanes(motion.position[center + 1]);
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d member = load_lanes(membership + i);
        visit(member * load_lanes(model.mass + i),
              Simd4dVector{load_lanes(k.x + i) - center_x, load_lanes(k.y + i) - center_y},
              Simd4dVector{load_lanes(k.velocity_x + i), load_lanes(k.velocity_y + i)},
              member * inertia_lanes(model, k, i), load_lanes(k.spin + i));
    }
}

// Adds a rate in rad/s to the rotation of the tree about its centre of mass. Returns the kinetic
// energy of all bodies afterwards.
CAMBRIAN_INLINE double turn_tree(const PlanarModel& model, int tree, double rate, Motion& motion,
                                 Kinematics& k) {
    const double* membership = model.members_of(tree).membership;
    const int center = center_of(model, tree);
    const Simd4d center_x = all_lanes(motion.position[center]);
    const Simd4d center_y = all_lanes(motion.position[center + 1]);
    Simd4d energy = {};
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d turn = rate * load_lanes(membership + i);
        const Simd4d turning = all_lanes(1.0) - load_lanes(model.slides + i);
        store_lanes(motion.speed + i, load_lanes(motion.speed + i) + turning * turn);
        if (k.deforms) continue;
        const Simd4d spin = load_lanes(k.spin + i) + turn;
        const Simd4d velocity_x =
            load_lanes(k.velocity_x + i) - turn * (load_lanes(k.y + i) - center_y);
        const Simd4d velocity_y =
            load_lanes(k.velocity_y + i) + turn * (load_lanes(k.x + i) - center_x);
        store_lanes(k.spin + i, spin);
        store_lanes(k.velocity_x + i, velocity_x);
        store_lanes(k.velocity_y + i, velocity_y);
        energy += doubled_energies(model, velocity_x, velocity_y, spin, i);
    }
    if (!k.deforms) return 0.5 * sum_of(energy);
    spread_spins(model, motion.speed, k.spin);
    compute_velocities(model, motion, k);
    return kinetic_energy(model, k);
}

// Returns the sum of the absolute angular momenta of the tree's bodies about its centre of mass,
// orbital and own, kg m^2/s.
double gross_spin_of_tree(const PlanarModel& model, const Motion& motion, const Kinematics& k,
                          int tree) {
    const int center = center_of(model, tree);
    const Simd4d speed_x = all_lanes(motion.speed[center]);
    const Simd4d speed_y = all_lanes(motion.speed[center + 1]);
    Simd4d gross = {};
    visit_bodies(model, motion, k, tree,
                 [&](const Simd4d& mass, const Simd4dVector& offset, const Simd4dVector& velocity,
                     const Simd4d& own, const Simd4d& spin) {
                     gross += mass * magnitude(offset.x * (velocity.y - speed_y) -
                                               offset.y * (velocity.x - speed_x)) +
                              own * magnitude(spin);
                 });
    return sum_of(gross);
}

}  // namespace

TreeSpin spin_of_tree(const PlanarModel& model, const Motion& motion, const Kinematics& k,
                      int tree) {
    Simd4d momentum = {};
    Simd4d inertia = {};
    visit_bodies(model, motion, k, tree,
                 [&](const Simd4d& mass, const Simd4dVector& offset, const Simd4dVector& velocity,
                     const Simd4d& own, const Simd4d& spin) {
                     momentum +=
                         mass * (offset.x * velocity.y - offset.y * velocity.x) + own * spin;
                     inertia += mass * (offset.x * offset.x + offset.y * offset.y) + own;
                 });
    CAMBRIAN_TICK_ASSERT(!(sum_of(inertia) <= 0.0), "a tree has inertia");
    return {sum_of(momentum), sum_of(inertia)};
}

double restore_spin(const PlanarModel& model, int tree, double before, double given, Motion& motion,
                    Kinematics& k) {
    const TreeSpin spin = spin_of_tree(model, motion, k, tree);
    const double gained = spin.momentum - before - given;
    return turn_tree(model, tree, -gained / spin.inertia, motion, k);
}

BodySet free_trees(const PlanarModel& model, const Forcing& forcing, const HeldForces& held) {
    const bool is_one = model.tree_count == 1;
    const Medium& medium = forcing.medium;
    if (!is_one &&
        (medium.drag_linear > 0.0 || medium.drag_quadratic > 0.0 || !forcing.pulls.empty()))
        return 0;
    BodySet touched = 0;
    for (int c = 0; c < held.contact_count && touched != model.roots; ++c) {
        const HeldForce& force = held.contacts[c];
        if (force.force_x != 0.0 || force.force_y != 0.0) touched |= touched_trees(model, force);
    }
    return model.roots & ~touched;
}

std::optional<double> restore_spins(const PlanarModel& model, const Medium& medium, BodySet free,
                                    bool is_last, SimulationState& state, Motion& end,
                                    Kinematics& end_kinematics) {
    const BodySet known = std::exchange(state.known_spins, free) & free;
    if (!is_last && known == free) return std::nullopt;
    std::optional<double> energy;
    BodySet left = free;
    for (int t = 0; left != 0; ++t) {
        const BodySet tree = BodySet{1} << model.tree_begin[t];
        if ((left & tree) == 0) continue;
        left &= ~tree;
        if ((known & tree) == 0)
            state.spin[t] =
                spin_of_tree(model, state.motion, state.cache().kinematics, t).momentum -
                state.motion.work[kSpinGiven];
        if (!is_last) continue;
        const double kinetic =
            restore_spin(model, t, state.spin[t], end.work[kSpinGiven], end, end_kinematics);
        energy = mechanical_energy(model, medium, end, kinetic);
    }
    return energy;
}

void check_spins(const PlanarModel& model, SimulationState& state) {
    const Kinematics& k = state.cache().kinematics;
    SceneAudit& audit = state.audit;
    for (int t = 0; t < model.tree_count; ++t) {
        if ((state.known_spins >> model.tree_begin[t] & 1U) == 0) continue;
        const TreeSpin spin = spin_of_tree(model, state.motion, k, t);
        const double gained = spin.momentum - state.spin[t] - state.motion.work[kSpinGiven];
        audit.spin_gained = std::max(audit.spin_gained, std::fabs(gained));
        audit.spin_scale =
            std::max(audit.spin_scale,
                     gross_spin_of_tree(model, state.motion, k, t) + kScaleSpin * spin.inertia);
    }
}

}  // namespace cambrian
