#include "dynamics/stepping/audit.h"

#include "core/assert.h"
#include "dynamics/model/kinematics.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kScaleHeight = 0.01;  // m

}  // namespace

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
    audit.energy_scale = audit.gross_motor_work + model.total_mass * gravity * kScaleHeight;
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

}  // namespace cambrian
