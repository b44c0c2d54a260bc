#include "planar/stepping/audit.h"

#include "core/assert.h"
#include "dynamics/step_policy.h"
#include "planar/model/kinematics.h"
#include "planar/model/stretching.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cambrian {
double mechanical_energy(const PlanarModel& model, const Medium& medium, const Motion& motion,
                         double kinetic) {
    double energy = kinetic;
    for (int t = 0; t < model.tree_count; ++t)
        energy -=
            model.tree_mass[t] * (medium.gravity_x * motion.position[center_of(model, t)] +
                                  medium.gravity_y * motion.position[center_of(model, t) + 1]);
    return energy;
}

double mechanical_energy(const PlanarModel& model, const Medium& medium, SimulationState& state) {
    if (!state.energy)
        state.energy = mechanical_energy(model, medium, state.motion,
                                         kinetic_energy(model, state.cache().kinematics));
    return *state.energy;
}

void note_speeds(const PlanarModel& model, const Kinematics& k, SceneAudit& audit) {
    Simd4d fastest = {};
    const bool single_boxes = has_single_boxes(model);
    for (int first = 0; first < model.part_count; first += kLanes) {
        const Simd4dVector velocity =
            single_boxes
                ? Simd4dVector{load_lanes(k.velocity_x + first), load_lanes(k.velocity_y + first)}
                : part_velocities(model, k, part_lanes(model, k, first), first);
        fastest = greater(fastest, velocity.x * velocity.x + velocity.y * velocity.y);
    }
    audit.max_part_speed = std::max(audit.max_part_speed, std::sqrt(largest_of(fastest)));
    Simd4d spin = {};
    for (int i = 0; i < model.body_count; i += kLanes)
        spin = greater(spin, magnitude(load_lanes(k.spin + i)));
    audit.max_part_spin = std::max(audit.max_part_spin, largest_of(spin));
}

void note_depths(const ContactSet& contacts, double limit_overrun, SceneAudit& audit) {
    CAMBRIAN_TICK_ASSERT(!(limit_overrun < 0.0), "an overrun is not negative");
    for (int c = 0; c < contacts.count; ++c)
        audit.max_penetration = std::max(audit.max_penetration, -contacts.items[c].gap);
    audit.max_limit_overrun = std::max(audit.max_limit_overrun, limit_overrun);
}

void note_member_works(const PlanarModel& model, const EvaluationCache& begin,
                       const EvaluationCache& end, double time, SimulationState& state) {
    for (int m = 0; m < model.member_count; ++m) {
        MemberWork& work = state.member_work[m];
        for (int i = model.member_begin[m]; i < model.member_begin[m + 1]; ++i) {
            const double before = begin.motor_effort[i] * begin.kinematics.joint_rate[i];
            const double after = end.motor_effort[i] * end.kinematics.joint_rate[i];
            work.net += 0.5 * time * (before + after);
            work.gross += 0.5 * time * (std::fabs(before) + std::fabs(after));
        }
    }
}

void update_audit(const PlanarModel& model, const Medium& medium, SimulationState& state) {
    SceneAudit& audit = state.audit;
    const double* work = state.motion.work;
    audit.motor_work = work[kMotorWork];
    audit.gross_motor_work = work[kGrossMotorWork];
    audit.drag_work = work[kDragWork];
    const double explained = work[kMotorWork] + work[kDragWork] + work[kPullWork] +
                             audit.contact_work + audit.limit_work + audit.impulse_work;
    audit.energy_residual =
        mechanical_energy(model, medium, state) - state.energy_reference - explained;
    const double gravity =
        std::sqrt(medium.gravity_x * medium.gravity_x + medium.gravity_y * medium.gravity_y);
    CAMBRIAN_TICK_ASSERT(!(audit.positive_work < 0.0), "what was given is not negative");
    audit.energy_scale =
        audit.gross_motor_work + model.total_mass * gravity * step_policy::kScaleHeight;
}

void start_audit(const PlanarModel& model, const Medium& medium, SimulationState& state) {
    for (double& work : state.motion.work)
        work = 0.0;
    state.known_spins = 0;
    state.audit = {};
    state.energy.reset();
    state.energy_reference = mechanical_energy(model, medium, state);
    update_audit(model, medium, state);
}

namespace {

// Returns the velocity of a part's centre, in m/s.
Vec2 center_velocity(const PlanarModel& model, const Kinematics& k, int part) {
    const int b = model.part_body[part];
    const double arm_x = k.cosine[b] * model.part_x[part] - k.sine[b] * model.part_y[part];
    const double arm_y = k.sine[b] * model.part_x[part] + k.cosine[b] * model.part_y[part];
    return {k.velocity_x[b] - k.spin[b] * arm_y, k.velocity_y[b] + k.spin[b] * arm_x};
}

bool is_measured(const PlanarModel& model, int part) {
    return part >= 0 && ((model.measured_parts >> static_cast<unsigned>(part)) & 1U) != 0;
}

template <class Visit>
void each_measured(const PlanarModel& model, const Visit& visit) {
    for (std::uint64_t left = model.measured_parts; left != 0; left &= left - 1)
        visit(std::countr_zero(left));
}

}  // namespace

void note_speeds(const PlanarModel& model, const Kinematics& kinematics, PartForces& forces) {
    each_measured(model, [&](int part) {
        const Vec2 velocity = center_velocity(model, kinematics, part);
        forces.speed_x[part] = velocity.x();
        forces.speed_y[part] = velocity.y();
    });
}

void begin_forces(const PlanarModel& model, PartForces& forces) {
    each_measured(model, [&](int part) { forces.load[part] = 0.0; });
}

void add_load(const PlanarModel& model, const Contact& contact, double impulse,
              PartForces& forces) {
    if (is_measured(model, contact.part_a)) forces.load[contact.part_a] += impulse;
    if (is_measured(model, contact.part_b)) forces.load[contact.part_b] += impulse;
}

void end_forces(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                double duration, PartForces& forces) {
    each_measured(model, [&](int part) {
        const Vec2 velocity = center_velocity(model, kinematics, part);
        forces.specific_x[part] =
            (velocity.x() - forces.speed_x[part]) / duration - medium.gravity_x;
        forces.specific_y[part] =
            (velocity.y() - forces.speed_y[part]) / duration - medium.gravity_y;
        forces.speed_x[part] = velocity.x();
        forces.speed_y[part] = velocity.y();
        forces.load[part] /= duration;
    });
}

namespace {

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

double restore_spin(const PlanarModel& model, int tree, double before, double given, Motion& motion,
                    Kinematics& k) {
    const TreeSpin spin = spin_of_tree(model, motion, k, tree);
    const double gained = spin.momentum - before - given;
    return turn_tree(model, tree, -gained / spin.inertia, motion, k);
}

}  // namespace cambrian
