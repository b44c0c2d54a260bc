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
    audit.max_penetration = std::max(audit.max_penetration, contacts.depth());
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
    const double* work = state.motion.work;
    const double gained = mechanical_energy(model, medium, state) - state.energy_reference;
    const double gravity =
        std::sqrt(medium.gravity_x * medium.gravity_x + medium.gravity_y * medium.gravity_y);
    step_policy::note_works(
        {work[kMotorWork], work[kGrossMotorWork], work[kDragWork], work[kPullWork]}, gained,
        model.total_mass * gravity, state.audit);
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

bool is_within_creature(const PlanarModel& model, const Contact& contact) {
    if (contact.body_b < 0) return false;
    const BodySet paths = model.root_path[contact.body_a] & model.root_path[contact.body_b];
    return (paths & model.roots) != 0;
}

}  // namespace

void note_touch(const Contact& contact, SimulationState& state) {
    state.touched[contact.part_a] |= static_cast<std::uint8_t>(1U << contact.face_a);
    if (contact.part_b >= 0)
        state.touched[contact.part_b] |= static_cast<std::uint8_t>(1U << contact.face_b);
}

void note_impact(const PlanarModel& model, const Kinematics& kinematics, const Contact& contact,
                 double impulse, double work, SimulationState& state) {
    if (is_within_creature(model, contact)) return;
    const auto end = state.impacts + state.impact_count;
    auto* noted = std::find_if(state.impacts, end, [&](const NotedImpact& each) {
        return each.body_a == contact.body_a && each.body_b == contact.body_b;
    });
    if (noted == end) {
        if (state.impact_count == static_cast<int>(kMostImpacts)) return;
        ++state.impact_count;
        *noted = {contact.body_a, contact.body_b, contact.part_a, contact.part_b};
    }
    noted->impulse += impulse;
    noted->lost -= work;
    noted->point_x += impulse * (kinematics.x[contact.body_a] + contact.arm_ax);
    noted->point_y += impulse * (kinematics.y[contact.body_a] + contact.arm_ay);
}

}  // namespace cambrian
