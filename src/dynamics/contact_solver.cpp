#include "dynamics/contact_solver.h"

#include "dynamics/ground_contacts.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kLimitBand = 1e-4;         // rad or m; nearer than this a stop gets a row
constexpr double kPushShare = 0.1;          // of a penetration, undone in one nominal step
constexpr double kPushSpeed = 0.5;          // m/s; cap of that
constexpr double kLimitPushSpeed = 1.0;     // rad/s or m/s
constexpr double kNominalStep = 1.0 / 120;  // s
constexpr double kWorkAllowance = 1e-3;     // J per (kg m/s^2): M g (1 m) * this
constexpr double kReferenceGravity = 9.81;  // m/s^2

// How far above its demand r + W p >= 0 a row may stay: lands at gap 0 with rate 0 in two steps,
// does not push what is leaving, and backs out of penetration gently.
double row_slack(double gap, double rate, double h, double push_speed) {
    if (gap < 0.0) return -std::fmin(push_speed, -kPushShare * gap / kNominalStep);
    if (rate <= 0.0) return std::fmax(0.0, gap / h + 0.5 * rate);
    return std::fmax(0.0, 2.0 * gap / h + rate);
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

bool ContactSolver::covers(const Contact& contact) const {
    for (int c = 0; c < chosen_.count; ++c) {
        if (same_pair(chosen_.items[c], contact)) return true;
    }
    return false;
}

// Touching contacts, and slow ones that could touch within the step; fast ones are left to the
// search for the time of impact.
bool ContactSolver::choose(const PlanarModel& model, const ContactLaw& law, const Motion& motion,
                           const Frame& frame, double h) {
    chosen_.count = 0;
    const BodyResponse& free = frame.response;
    for (int c = 0; c < near_.count; ++c) {
        const Contact& contact = near_.items[c];
        const int a = contact.body_a;
        double acceleration = contact.normal_x * (free.x[a] - free.spin[a] * contact.arm_ay) +
                              contact.normal_y * (free.y[a] + free.spin[a] * contact.arm_ax);
        if (contact.body_b >= 0) {
            const int b = contact.body_b;
            acceleration -= contact.normal_x * (free.x[b] - free.spin[b] * contact.arm_by) +
                            contact.normal_y * (free.y[b] + free.spin[b] * contact.arm_bx);
        }
        const double reach = kContactBand + 1.5 * h * std::fmax(0.0, contact.closing_speed) +
                             h * h * std::fmax(0.0, -acceleration);
        const bool slow = contact.closing_speed <= kRestingSpeed;
        if (contact.gap < kContactBand || (slow && contact.gap < reach)) chosen_.add(contact);
    }
    choose_limits(model, motion, frame, h);
    if (chosen_.count == 0 && limit_count_ == 0) return false;
    build_rows(model, motion, frame, chosen_, limits_, limit_count_, law.friction > 0.0, rows_);
    return true;
}

void ContactSolver::choose_limits(const PlanarModel& model, const Motion& motion,
                                  const Frame& frame, double h) {
    limit_count_ = 0;
    for (int i = 1; i < model.body_count; ++i) {
        const double angle = joint_coordinate(model, motion, frame.kinematics, i);
        const double rate = joint_rate(model, motion, frame.kinematics, i);
        double acceleration = frame.response.coordinate[coordinate_of(i)];
        if (model.joint[i] == JointType::kRotary)
            acceleration -= frame.response.spin[model.parent[i]];
        const auto consider = [&](double sign, double gap) {
            const double reach = kLimitBand + 1.5 * h * std::fmax(0.0, -sign * rate) +
                                 h * h * std::fmax(0.0, -sign * acceleration);
            if (gap < reach) limits_[limit_count_++] = {i, sign, gap};
        };
        consider(1.0, angle - model.limit_low[i]);
        consider(-1.0, model.limit_high[i] - angle);
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
            bias[row] += row_slack(limits_[rows_.source[row]].gap, rate, h, kLimitPushSpeed);
    }
}

bool ContactSolver::hold(const PlanarModel& model, const ContactLaw& law, double h, WarmStart& warm,
                         Forcing& forcing) {
    set_resting_bias(h, bias_);
    load_warm_start(h, warm);
    const bool solved = solve_resting(model, law, h);
    store_forces(h, warm, forcing);
    return solved;
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
            rows_.impulse[row] = h * std::fmax(0.0, effort);
            continue;
        }
        const int id = chosen_.items[rows_.source[row]].id;
        for (int w = 0; w < warm.count; ++w) {
            if (warm.id[w] != id) continue;
            const bool normal = rows_.kind[row] == RowKind::kNormal;
            rows_.impulse[row] = h * (normal ? warm.normal[w] : warm.friction[w]);
        }
    }
}

void ContactSolver::store_forces(double h, WarmStart& warm, Forcing& forcing) {
    warm.count = chosen_.count;
    forcing.contact_count = chosen_.count;
    forcing.limits_active = limit_count_ > 0;
    for (int c = 0; c < chosen_.count; ++c) {
        const Contact& contact = chosen_.items[c];
        warm.id[c] = contact.id;
        warm.normal[c] = 0.0;
        warm.friction[c] = 0.0;
        forcing.contacts[c] = {
            contact.body_a, contact.body_b, contact.point_x, contact.point_y, 0.0, 0.0};
    }
    for (int i = 0; i < kMaxBodies; ++i) {
        warm.limit[i] = 0.0;
        forcing.limit_effort[i] = 0.0;
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
                                  const Frame& start, const Motion& start_motion,
                                  const Kinematics& end, const Motion& end_motion) const {
    HeldWork work;
    const Kinematics& begin = start.kinematics;
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
        work.positive += std::fmax(0.0, done);
    }
    if (!forcing.limits_active) return work;
    for (int i = 1; i < model.body_count; ++i) {
        const double effort = forcing.limit_effort[i];
        if (effort == 0.0) continue;
        const double done = effort * (joint_coordinate(model, end_motion, end, i) -
                                      joint_coordinate(model, start_motion, begin, i));
        work.limit += done;
        work.positive += std::fmax(0.0, done);
    }
    return work;
}

}  // namespace cambrian
