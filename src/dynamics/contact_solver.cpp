#include "dynamics/contact_solver.h"

#include "dynamics/ground_contacts.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kLimitBand = 1e-4;         // rad or m; nearer than this a stop gets a row
constexpr double kPushShare = 0.1;          // of a penetration, undone in one nominal step
constexpr double kPushSpeed = 0.5;          // m/s; cap of that
constexpr double kLimitPushSpeed = 1.0;     // rad/s or m/s
constexpr double kNominalStep = 1.0 / 120;  // s
constexpr double kWorkAllowance = 1e-3;     // J per (kg m/s^2): M g (1 m) * this
constexpr double kAnchorWeights = 10.0;     // weights of the body that friction holds without slip
constexpr double kReferenceGravity = 9.81;  // m/s^2
constexpr double kFrictionSoftness = 1e-2;  // anchored at the last step's forces

// How far above its demand r + W p >= 0 a row may stay: lands at gap 0 with rate 0 in two steps,
// does not push what is leaving, and backs out of penetration with a force that stays bounded as h
// shrinks.
double row_slack(double gap, double rate, double h, double push_speed) {
    if (gap < 0.0) {
        const double push = std::min(push_speed, -kPushShare * gap / kNominalStep);
        return -push * std::min(1.0, h / kNominalStep);
    }
    if (rate <= 0.0) return std::max(0.0, gap / h + 0.5 * rate);
    return std::max(0.0, 2.0 * gap / h + rate);
}

// Whether a slow contact could reach the band within a step of length h.
bool may_touch(const Contact& contact, const BodyResponse& free, double h) {
    if (contact.closing_speed > kRestingSpeed) return false;
    const int a = contact.body_a;
    double acceleration = contact.normal_x * (free.x[a] - free.spin[a] * contact.arm_ay) +
                          contact.normal_y * (free.y[a] + free.spin[a] * contact.arm_ax);
    if (contact.body_b >= 0) {
        const int b = contact.body_b;
        acceleration -= contact.normal_x * (free.x[b] - free.spin[b] * contact.arm_by) +
                        contact.normal_y * (free.y[b] + free.spin[b] * contact.arm_bx);
    }
    const double reach = kContactBand + 1.5 * h * std::max(0.0, contact.closing_speed) +
                         h * h * std::max(0.0, -acceleration);
    return contact.gap < reach;
}

}  // namespace

void ContactSolver::collect(const PlanarModel& model, const ContactLaw& law,
                            const Kinematics& kinematics) {
    near_.count = 0;
    PartPlaces places;
    place_parts(model, kinematics, places);
    if (law.has_ground) collect_ground_contacts(model, kinematics, places, near_);
    pair_list_.collect(model, kinematics, places, near_);
}

bool ContactSolver::has_impact() const {
    for (int c = 0; c < near_.count; ++c) {
        const Contact& contact = near_.items[c];
        if (contact.gap < kContactBand && contact.closing_speed > kRestingSpeed) return true;
    }
    return false;
}

// One point of two boxes answers for another only once they overlap: their corners may take turns
// then, but a corner that is still to come must be found.
bool ContactSolver::covers(const Contact& contact) const {
    for (int c = 0; c < chosen_.count; ++c) {
        const Contact& chosen = chosen_.items[c];
        if (chosen.id == contact.id) return true;
        if (chosen.gap < 0.0 && same_pair(chosen, contact)) return true;
    }
    return false;
}

// Touching contacts, and slow ones that could touch within the step; fast ones are left to the
// search for the time of impact.
bool ContactSolver::choose(const PlanarModel& model, const ContactLaw& law, const Motion& motion,
                           const Frame& frame, double h) {
    chosen_.count = 0;
    for (int c = 0; c < near_.count; ++c) {
        const Contact& contact = near_.items[c];
        if (contact.gap < kContactBand || may_touch(contact, frame.response, h))
            chosen_.add(contact);
    }
    choose_limits(model, frame, h);
    if (chosen_.count == 0 && limits_.count == 0) return false;
    build_rows(model, motion, frame, {chosen_, limits_, law.friction > 0.0, kFrictionSoftness},
               rows_);
    return true;
}

// Stops that could be reached within the step.
void ContactSolver::choose_limits(const PlanarModel& model, const Frame& frame, double h) {
    limits_.count = 0;
    const Kinematics& k = frame.kinematics;
    PerBody low_room;
    PerBody high_room;
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Lanes angle = load_lanes(k.joint_position + i);
        const Lanes rate = load_lanes(k.joint_rate + i);
        const Lanes turning = all_lanes(1.0) - load_lanes(model.slides + i);
        const Lanes acceleration = load_lanes(frame.response.coordinate + i) -
                                   turning * gather(frame.response.spin, model.parent_slot + i);
        const Lanes low_reach = kLimitBand + 1.5 * h * greater(-rate, Lanes{}) +
                                h * h * greater(-acceleration, Lanes{});
        const Lanes high_reach =
            kLimitBand + 1.5 * h * greater(rate, Lanes{}) + h * h * greater(acceleration, Lanes{});
        store_lanes(low_room + i, angle - load_lanes(model.limit_low + i) - low_reach);
        store_lanes(high_room + i, load_lanes(model.limit_high + i) - angle - high_reach);
    }
    for (int i = 0; i < model.body_count; ++i) {
        if (low_room[i] >= 0.0 && high_room[i] >= 0.0) continue;
        if (model.parent[i] < 0) continue;
        const double angle = k.joint_position[i];
        if (low_room[i] < 0.0) limits_.add({i, 1.0, angle - model.limit_low[i]});
        if (high_room[i] < 0.0) limits_.add({i, -1.0, model.limit_high[i] - angle});
    }
}

void ContactSolver::set_resting_bias(double h, double* bias) const {
    for (int row = 0; row < rows_.count; ++row) {
        const double rate = rows_.rate[row];
        bias[row] = rate + h * rows_.acceleration[row];
        if (rows_.kind[row] == RowKind::kNormal)
            bias[row] +=
                row_slack(chosen_.items[rows_.source[row]].gap - kRestingGap, rate, h, kPushSpeed);
        if (rows_.kind[row] == RowKind::kLimit)
            bias[row] += row_slack(limits_.items[rows_.source[row]].gap, rate, h, kLimitPushSpeed);
    }
}

bool ContactSolver::hold(const PlanarModel& model, const ContactLaw& law, double h, WarmStart& warm,
                         Forcing& forcing) {
    set_resting_bias(h, bias_);
    load_warm_start(h, warm);
    anchor_friction(model, h);
    const bool solved = solve_resting(model, law, h);
    store_forces(model.body_count, h, warm, forcing);
    return solved;
}

// The softness of friction rows pulls towards the last step's force, not towards none: what holds
// still keeps holding still, without creep. Only up to a few times the weight: parts wedged against
// each other would keep any stress they once built up.
void ContactSolver::anchor_friction(const PlanarModel& model, double h) {
    const double most = kAnchorWeights * model.total_mass * kReferenceGravity * h;
    for (int row = 0; row < rows_.count; ++row) {
        if (rows_.kind[row] != RowKind::kFriction) continue;
        const double anchor = std::clamp(rows_.impulse[row], -most, most);
        bias_[row] -= rows_.regularization[row] * anchor;
    }
}

void ContactSolver::let_go() {
    for (int c = 0; c < chosen_.count; ++c)
        normal_force_[c] = 0.0;
}

bool ContactSolver::solve_resting(const PlanarModel& model, const ContactLaw& law, double h) {
    const double allowance = kWorkAllowance * model.total_mass * kReferenceGravity;
    bool solved = solver_.solve(rows_, bias_, law.friction);
    if (resting_work(h) <= allowance) return solved;
    solver_.iterate_from_zero(rows_, bias_, law.friction);
    if (resting_work(h) > allowance) solver_.iterate_from_zero(rows_, bias_, 0.0);
    return false;
}

// Work the impulses would do over a step of constant forces.
double ContactSolver::resting_work(double h) const {
    double work = 0.0;
    for (int row = 0; row < rows_.count; ++row) {
        if (rows_.impulse[row] == 0.0) continue;
        work +=
            rows_.impulse[row] *
            (rows_.rate[row] + 0.5 * (h * rows_.acceleration[row] + impulse_effect(rows_, row)));
    }
    return work;
}

void ContactSolver::load_warm_start(double h, const WarmStart& warm) {
    for (int row = 0; row < rows_.count; ++row) {
        rows_.impulse[row] = 0.0;
        if (rows_.kind[row] == RowKind::kLimit) {
            const double effort = rows_.dir_x[row] * warm.limit[rows_.body_a[row]];
            rows_.impulse[row] = h * std::max(0.0, effort);
            continue;
        }
        const Contact& contact = chosen_.items[rows_.source[row]];
        const bool normal = rows_.kind[row] == RowKind::kNormal;
        for (int w = 0; w < warm.count; ++w) {
            if (normal && warm.id[w] == contact.id) rows_.impulse[row] = h * warm.normal[w];
            if (!normal && warm.group[w] == friction_group(contact))
                rows_.impulse[row] += h * warm.friction[w];
        }
    }
}

void ContactSolver::store_forces(int body_count, double h, WarmStart& warm, Forcing& forcing) {
    warm.count = chosen_.count;
    forcing.contact_count = chosen_.count;
    forcing.limits_active = limits_.count > 0;
    for (int c = 0; c < chosen_.count; ++c) {
        const Contact& contact = chosen_.items[c];
        warm.id[c] = contact.id;
        warm.group[c] = friction_group(contact);
        warm.normal[c] = 0.0;
        warm.friction[c] = 0.0;
        forcing.contacts[c] = {
            contact.body_a, contact.body_b, contact.point_x, contact.point_y, 0.0, 0.0};
    }
    for (int i = 0; i < body_count; i += kLanes) {
        store_lanes(warm.limit + i, Lanes{});
        store_lanes(forcing.limit_effort + i, Lanes{});
    }
    for (int row = 0; row < rows_.count; ++row) {
        const double force = rows_.impulse[row] / h;
        if (rows_.kind[row] == RowKind::kLimit) {
            warm.limit[rows_.body_a[row]] += rows_.dir_x[row] * force;
            forcing.limit_effort[rows_.body_a[row]] += rows_.dir_x[row] * force;
            continue;
        }
        const int c = rows_.source[row];
        forcing.contacts[c].force_x += rows_.dir_x[row] * force;
        forcing.contacts[c].force_y += rows_.dir_y[row] * force;
        (rows_.kind[row] == RowKind::kNormal ? warm.normal : warm.friction)[c] = force;
    }
    for (int c = 0; c < chosen_.count; ++c)
        normal_force_[c] = warm.normal[c];
}

HeldWork ContactSolver::held_work(const PlanarModel& model, const Forcing& forcing,
                                  const Kinematics& begin, const Kinematics& end) const {
    HeldWork work;
    const auto world = [](const Kinematics& k, const HeldForce& held, double& x, double& y) {
        const int a = held.body_a;
        x = k.x[a] + k.cosine[a] * held.point_x - k.sine[a] * held.point_y;
        y = k.y[a] + k.sine[a] * held.point_x + k.cosine[a] * held.point_y;
    };
    for (int c = 0; c < forcing.contact_count; ++c) {
        const HeldForce& held = forcing.contacts[c];
        double start_x = 0.0;
        double start_y = 0.0;
        double end_x = 0.0;
        double end_y = 0.0;
        world(begin, held, start_x, start_y);
        world(end, held, end_x, end_y);
        double done = held.force_x * (end_x - start_x) + held.force_y * (end_y - start_y);
        const int b = held.body_b;
        if (b >= 0) {
            const double turn = end.angle[b] - begin.angle[b];
            const double arm_x = 0.5 * (start_x - begin.x[b] + end_x - end.x[b]);
            const double arm_y = 0.5 * (start_y - begin.y[b] + end_y - end.y[b]);
            done -= held.force_x * (end.x[b] - begin.x[b] - turn * arm_y) +
                    held.force_y * (end.y[b] - begin.y[b] + turn * arm_x);
        }
        work.contact += done;
        work.positive += std::max(0.0, done);
    }
    if (!forcing.limits_active) return work;
    for (int i = 0; i < model.body_count; ++i) {
        const double effort = forcing.limit_effort[i];
        if (effort == 0.0) continue;
        const double done = effort * (end.joint_position[i] - begin.joint_position[i]);
        work.limit += done;
        work.positive += std::max(0.0, done);
    }
    return work;
}

}  // namespace cambrian
