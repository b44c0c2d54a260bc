#include "planar/constraints/contact_solver.h"

#include "planar/constraints/invariants.h"
#include "planar/contact/fixed_contacts.h"
#include "planar/contact/terrain_contacts.h"
#include "planar/model/stretching.h"
#include "world/environment.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kLimitBand = 1e-4;  // rad or m; a nearer limit gets a row
constexpr double kPushShare = 0.1;   // share of a penetration that is corrected in one nominal step
constexpr double kNominalStep = 1.0 / 120;        // s
constexpr double kMiddleWorkAllowance = 1e-3;     // J per (kg m/s^2): M g (1 m) * this
constexpr double kMiddleFrictionSoftness = 1e-2;  // anchored at the last step's forces

// The slack of a row, r + slack + W p >= 0 (planar/README.md 11). A closing contact lands at gap
// 0 with rate 0 in two steps. Penetration is undone at a speed that remains bounded as h shrinks. A
// contact that opens fast enough to undo the penetration within the step is not pushed.
double row_slack(double gap, double rate, double h, double push_speed) {
    if (gap < 0.0) {
        const double push = std::min(push_speed, -kPushShare * gap / kNominalStep);
        const double back = push * std::min(1.0, h / kNominalStep);
        return std::max(-back, rate - 2.0 * back);
    }
    if (rate <= 0.0) return std::max(0.0, gap / h + 0.5 * rate);
    return std::max(0.0, 2.0 * gap / h + rate);
}

// The acceleration of a contact's gap by the stretches of its bodies.
double stretch_acceleration(const PlanarModel& model, const Kinematics& k, const Contact& contact,
                            const BodyResponse& free) {
    const auto of_body = [&](int body, double arm_x, double arm_y) {
        const int slot = body < 0 ? -1 : model.stretch_slot[body];
        if (slot < 0) return 0.0;
        const Simd2d lever = stretch_lever(k, body, arm_x, arm_y);
        return free.coordinate[slot] * dot(Simd2d{contact.normal_x, contact.normal_y}, lever);
    };
    return of_body(contact.body_a, contact.arm_ax, contact.arm_ay) -
           of_body(contact.body_b, contact.arm_bx, contact.arm_by);
}

// Adds what deformable bodies do to contacts that were found with the present shapes: the material
// points of pairs are those of rest shapes, and stretching moves both points.
void stretch_contacts(const Kinematics& k, ContactSet& contacts) {
    for (int i = 0; i < contacts.count; ++i) {
        Contact& c = contacts.items[i];
        Simd2d velocity = stretch_velocity(k, c.body_a, c.arm_ax, c.arm_ay);
        if (!is_on_ground(c)) {
            c.point_x *= k.width_growth[c.body_a];
            c.point_y *= k.length_growth[c.body_a];
        }
        if (c.body_b >= 0) {
            velocity -= stretch_velocity(k, c.body_b, c.arm_bx, c.arm_by);
        }
        c.closing_speed -= dot(Simd2d{c.normal_x, c.normal_y}, velocity);
    }
}

// Whether a slow contact could reach the band within a step of length h.
bool may_touch(const PlanarModel& model, const Contact& contact, const EvaluationCache& cache,
               double h) {
    const BodyResponse& free = cache.response;
    if (contact.closing_speed > kRestingSpeed) return false;
    const int a = contact.body_a;
    double acceleration = contact.normal_x * (free.x[a] - free.spin[a] * contact.arm_ay) +
                          contact.normal_y * (free.y[a] + free.spin[a] * contact.arm_ax);
    if (contact.body_b >= 0) {
        const int b = contact.body_b;
        acceleration -= contact.normal_x * (free.x[b] - free.spin[b] * contact.arm_by) +
                        contact.normal_y * (free.y[b] + free.spin[b] * contact.arm_bx);
    }
    if (cache.kinematics.deforms)
        acceleration += stretch_acceleration(model, cache.kinematics, contact, free);
    const double reach = kContactBand + 1.5 * h * std::max(0.0, contact.closing_speed) +
                         h * h * std::max(0.0, -acceleration);
    return contact.gap < reach;
}

// The work of a held force on the stretch of its body b, with the mean arm of the step.
double stretch_work(const PlanarModel& model, const Kinematics& begin, const Kinematics& end,
                    const HeldForce& held, const Simd2d& arm) {
    const int slot = model.stretch_slot[held.body_b];
    if (slot < 0) return 0.0;
    const Simd2d lever = stretch_lever(begin, held.body_b, arm[0], arm[1]) +
                         stretch_lever(end, held.body_b, arm[0], arm[1]);
    return 0.5 * (end.joint_position[slot] - begin.joint_position[slot]) *
           dot(lever, Simd2d{held.force_x, held.force_y});
}

// Finds the forces of the last step by contact. Contacts are looked up in the order of detection,
// in which the forces are stored.
class WarmForces {
public:
    explicit WarmForces(const WarmStart& warm) : warm_(warm) {}

    double normal(int id) {
        const int rank = pass_to(id);
        for (int w = next_; is_of(rank, w); ++w) {
            if (warm_.id[w] == id) return warm_.normal[w];
        }
        return 0.0;
    }
    double pair_friction(int id) {
        const int rank = pass_to(id);
        double sum = 0.0;
        for (int w = next_; is_of(rank, w); ++w)
            sum += warm_.friction[w];
        return sum;
    }

private:
    bool is_of(int rank, int w) const {
        return w < warm_.count && detection_rank(warm_.id[w]) == rank;
    }
    int pass_to(int id) {
        const int rank = detection_rank(id);
        while (next_ < warm_.count && detection_rank(warm_.id[next_]) < rank)
            ++next_;
        return rank;
    }

    const WarmStart& warm_;
    int next_ = 0;
};

}  // namespace

void ContactSolver::detect(const PlanarModel& model, const ContactLaw& law,
                           const Kinematics& kinematics) {
    near_.count = 0;
    near_.most = model.contact_count;
    if (!law.has_ground && law.fixed.empty() && model.colliding_pairs.empty()) return;
    latest_ = 1 - latest_;
    PartPlaces& places = places_[latest_];
    place_parts(model, kinematics, places);
    if (law.terrain != nullptr)
        detect_terrain_contacts(model, kinematics, places, {*law.terrain, terrain_guess_}, near_);
    else if (law.has_ground)
        detect_ground_contacts(model, kinematics, places, near_);
    pair_list_.detect(model, kinematics, places, near_);
    if (!law.fixed.empty()) detect_fixed_contacts(model, kinematics, places, law.fixed, near_);
    if (kinematics.deforms) stretch_contacts(kinematics, near_);
    CAMBRIAN_TICK_ASSERT(near_.count >= 0 && near_.count <= kMaxContacts, "contacts have room");
}

int ContactSolver::count_looks(const PlanarModel& model, const ContactLaw& law,
                               const Kinematics& from, const Kinematics& to) {
    const bool has_pairs = !model.colliding_pairs.empty() && !pair_list_.is_empty();
    const bool has_fixed = !law.fixed.empty() || law.terrain != nullptr;
    if (!has_fixed && !has_pairs) return 1;
    const BoxEnds ends{model, places_[1 - latest_], places_[latest_]};
    if (model.stretch_count > 0 || !has_sides_) {
        use_sizes(model, places_[0]);
        use_sizes(model, places_[1]);
        find_sides(ends, sides_);
        has_sides_ = true;
    }
    BoxTravels travels;
    find_travels(ends, from.angle, to.angle, travels);
    const bool may_pass = has_pairs && travels.most_past > sides_.thinnest;
    if (!may_pass && !has_fixed) return 1;
    use_sizes(model, places_[0]);
    use_sizes(model, places_[1]);
    double looks = may_pass ? pair_list_.count_looks(ends, travels, sides_) : 1.0;
    if (!law.fixed.empty())
        looks = std::max(looks, count_looks_at_fixed(ends, travels, sides_, law.fixed));
    if (law.terrain != nullptr)
        looks = std::max(looks, count_looks_at_terrain(ends, travels, *law.terrain));
    return static_cast<int>(std::ceil(std::min(looks, kMostLooks + 1.0)));
}

bool ContactSolver::has_impact() const {
    for (int c = 0; c < near_.count; ++c) {
        const Contact& contact = near_.items[c];
        if (contact.gap < kContactBand && contact.closing_speed > kRestingSpeed) return true;
    }
    return false;
}

// One contact of a pair of boxes covers another only if they overlap, because their corners may
// then alternate. The first corner that touches must be found as an impact.
bool ContactSolver::covers(const Contact& contact) const {
    for (int c = 0; c < selected_.count; ++c) {
        const Contact& selected = selected_.items[c];
        if (selected.id == contact.id) return true;
        if (selected.gap < 0.0 && same_pair(selected, contact)) return true;
    }
    return false;
}

// Selects touching contacts and slow ones that may touch within the step. The search for the time
// of impact finds the fast ones.
bool ContactSolver::select_active(const PlanarModel& model, EvaluationCache& cache, double h) {
    CAMBRIAN_TICK_ASSERT(h > 0.0, "a step takes time");
    selected_.count = 0;
    selected_.most = near_.most;
    for (int c = 0; c < near_.count; ++c) {
        const Contact& contact = near_.items[c];
        if (contact.gap >= kContactBand) {
            find_centers(model, cache);
            if (!may_touch(model, contact, cache, h)) continue;
        }
        selected_.add(contact);
    }
    select_limits(model, cache, h);
    CAMBRIAN_TICK_ASSERT(selected_.count <= near_.count, "selected contacts are near");
    return selected_.count > 0 || limits_.count > 0;
}

void ContactSolver::build(const PlanarModel& model, const ContactLaw& law, EvaluationCache& start) {
    complete_cache(model, start);
    build_between(model, law, start.kinematics, start);
}

void ContactSolver::build_between(const PlanarModel& model, const ContactLaw& law,
                                  const Kinematics& start, const EvaluationCache& middle) {
    build_rows(model, {selected_, limits_, law.friction > 0.0, kMiddleFrictionSoftness}, start,
               middle, rows_);
}

// Selects the joint limits that may be reached within the step.
void ContactSolver::select_limits(const PlanarModel& model, const EvaluationCache& cache,
                                  double h) {
    limits_.count = 0;
    const Kinematics& k = cache.kinematics;
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d angle = load_lanes(k.joint_position + i);
        const Simd4d rate = load_lanes(k.joint_rate + i);
        const Simd4d turning = all_lanes(1.0) - load_lanes(model.slides + i);
        const Simd4d acceleration = load_lanes(cache.response.coordinate + i) -
                                    turning * gather(cache.response.spin, model.parent_slot + i);
        const Simd4d low_reach = kLimitBand + 1.5 * h * greater(-rate, Simd4d{}) +
                                 h * h * greater(-acceleration, Simd4d{});
        const Simd4d high_reach = kLimitBand + 1.5 * h * greater(rate, Simd4d{}) +
                                  h * h * greater(acceleration, Simd4d{});
        const Simd4d low_room = angle - load_lanes(model.limit_low + i) - low_reach;
        const Simd4d high_room = load_lanes(model.limit_high + i) - angle - high_reach;
        const unsigned low = true_lanes(low_room < Simd4d{});
        const unsigned high = true_lanes(high_room < Simd4d{});
        if ((low | high) != 0) add_limits(model, k, i, low, high);
    }
}

// Adds the limits of four joints that are in these sets of lanes.
void ContactSolver::add_limits(const PlanarModel& model, const Kinematics& k, int first,
                               unsigned low, unsigned high) {
    for (unsigned left = low | high; left != 0; left &= left - 1) {
        const int lane = std::countr_zero(left);
        const int i = first + lane;
        if (i >= model.body_count || model.parent[i] < 0) continue;
        const double angle = k.joint_position[i];
        if ((low >> lane & 1U) != 0) limits_.add({i, 1.0, angle - model.limit_low[i]});
        if ((high >> lane & 1U) != 0) limits_.add({i, -1.0, model.limit_high[i] - angle});
        CAMBRIAN_TICK_ASSERT(limits_.count <= 2 * kMaxBodies, "stops have room");
    }
}

// Sets first guesses and biases. The softness of friction rows pulls towards the last step's force
// and not towards 0, so that a resting creature does not creep. The force is limited to a few
// weights, because wedged parts would otherwise keep any stress indefinitely.
void ContactSolver::set_resting_bias(const PlanarModel& model, double h, const WarmStart& warm) {
    CAMBRIAN_TICK_ASSERT(h > 0.0, "a step takes time");
    CAMBRIAN_TICK_ASSERT(warm.count <= kMaxContacts, "remembered forces have room");
    const double most = kAnchorWeights * model.total_mass * kEarthGravity * h;
    WarmForces forces(warm);
    for (int r = 0; r < rows_.count; ++r) {
        const Row& row = rows_[r];
        double force = 0.0;
        double bias = row.rate + h * row.acceleration;
        if (row.kind == RowKind::kNormal) {
            const Contact& contact = selected_.items[row.source];
            force = forces.normal(contact.id);
            bias += row_slack(contact.gap - kRestingGap, row.rate, h, kPushSpeed);
        } else if (row.kind == RowKind::kFriction) {
            const Contact& contact = selected_.items[row.source];
            force = is_on_ground(contact) ? warm.ground_friction[row.body_a]
                                          : forces.pair_friction(contact.id);
            bias -= row.regularization * std::clamp(h * force, -most, most);
        } else {
            force = std::max(0.0, row.dir_x * warm.limit[row.body_a]);
            bias += row_slack(limits_.items[row.source].gap, row.rate, h, kStopPushSpeed);
        }
        rows_.impulse[r] = h * force;
        bias_[r] = bias;
    }
}

bool ContactSolver::solve_resting(const PlanarModel& model, const ContactLaw& law, double h,
                                  WarmStart& warm) {
    set_resting_bias(model, h, warm);
    const bool solved = solve_rows(model, law, h);
    CAMBRIAN_TICK_ASSERT(do_only_push(rows_), "contacts and stops do not pull");
    CAMBRIAN_TICK_ASSERT(!solved || are_in_cones(rows_, law.friction),
                         "friction that is solved for stays in its cone");
    store_forces(model.body_count, h, warm);
    return solved;
}

bool ContactSolver::holds_something() const {
    for (int row = 0; row < rows_.count; ++row) {
        if (rows_.impulse[row] != 0.0) return true;
    }
    return false;
}

bool ContactSolver::absorb(const PlanarModel& model, const ContactLaw& law,
                           const BodyResponse (&changes)[2], Loads (&loads)[2]) {
    RowChanges rows;
    rate_rows(model, rows_, changes, rows.rates);
    CAMBRIAN_TICK_ASSERT(law.friction >= 0.0, "friction is not negative");
    if (!solver_.absorb(rows_, law.friction, rows)) return false;
    for (int which = 0; which < 2; ++which)
        add_row_impulses(rows_, rows.impulses[which], 1.0, loads[which]);
    return true;
}

void ContactSolver::clear() {
    held_.contact_count = 0;
    held_.limits_active = false;
    for (int c = 0; c < selected_.count; ++c)
        normal_force_[c] = 0.0;
}

bool ContactSolver::solve_rows(const PlanarModel& model, const ContactLaw& law, double h) {
    const double allowance = kMiddleWorkAllowance * model.total_mass * kEarthGravity;
    bool solved = solver_.solve(rows_, bias_, law.friction);
    if (resting_work(h) <= allowance) return solved;
    solver_.iterate_from_zero(rows_, bias_, law.friction);
    if (resting_work(h) > allowance) solver_.iterate_from_zero(rows_, bias_, 0.0);
    return false;
}

// Returns the work of the impulses over a step of constant forces.
double ContactSolver::resting_work(double h) const {
    double work = 0.0;
    for (int row = 0; row < rows_.count; ++row) {
        if (rows_.impulse[row] == 0.0) continue;
        work +=
            rows_.impulse[row] *
            (rows_[row].rate + 0.5 * (h * rows_[row].acceleration + impulse_effect(rows_, row)));
    }
    return work;
}

void ContactSolver::store_forces(int body_count, double h, WarmStart& warm) {
    warm.count = selected_.count;
    held_.contact_count = selected_.count;
    held_.limits_active = limits_.count > 0;
    for (int c = 0; c < selected_.count; ++c) {
        const Contact& contact = selected_.items[c];
        warm.id[c] = contact.id;
        warm.normal[c] = 0.0;
        warm.friction[c] = 0.0;
        held_.contacts[c] = {
            contact.body_a, contact.body_b, contact.point_x, contact.point_y, 0.0, 0.0};
    }
    for (int i = 0; i < body_count; i += kLanes) {
        store_lanes(warm.ground_friction + i, Simd4d{});
        store_lanes(warm.limit + i, Simd4d{});
        store_lanes(held_.limit_effort + i, Simd4d{});
    }
    for (int r = 0; r < rows_.count; ++r) {
        if (rows_.impulse[r] == 0.0) continue;
        const Row& row = rows_[r];
        const double force = rows_.impulse[r] / h;
        if (row.kind == RowKind::kLimit) {
            warm.limit[row.body_a] += row.dir_x * force;
            held_.limit_effort[row.body_a] += row.dir_x * force;
            continue;
        }
        CAMBRIAN_TICK_ASSERT(row.source >= 0 && row.source < held_.contact_count,
                             "a row of a contact");
        HeldForce& held = held_.contacts[row.source];
        held.force_x += row.dir_x * force;
        held.force_y += row.dir_y * force;
        if (row.kind == RowKind::kNormal)
            warm.normal[row.source] = force;
        else if (is_on_ground(selected_.items[row.source]))
            warm.ground_friction[row.body_a] = force;
        else
            warm.friction[row.source] = force;
    }
    for (int c = 0; c < selected_.count; ++c)
        normal_force_[c] = warm.normal[c];
}

HeldWork ContactSolver::held_work(const PlanarModel& model, const Kinematics& begin,
                                  const Kinematics& end) const {
    HeldWork work;
    const auto world = [](const Kinematics& k, const HeldForce& held, double& x, double& y) {
        const int a = held.body_a;
        double point_x = held.point_x;
        double point_y = held.point_y;
        stretch_point(k, a, point_x, point_y);
        x = k.x[a] + k.cosine[a] * point_x - k.sine[a] * point_y;
        y = k.y[a] + k.sine[a] * point_x + k.cosine[a] * point_y;
    };
    for (int c = 0; c < held_.contact_count; ++c) {
        const HeldForce& held = held_.contacts[c];
        CAMBRIAN_TICK_ASSERT(is_body(model, held.body_a) && is_body_or_ground(model, held.body_b),
                             "a contact of bodies");
        if (held.force_x == 0.0 && held.force_y == 0.0) continue;
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
            if (begin.deforms) done -= stretch_work(model, begin, end, held, Simd2d{arm_x, arm_y});
        }
        work.contact += done;
        work.positive += std::max(0.0, done);
    }
    if (!held_.limits_active) return work;
    for (int i = 0; i < model.body_count; ++i) {
        const double effort = held_.limit_effort[i];
        if (effort == 0.0) continue;
        CAMBRIAN_TICK_ASSERT(model.parent[i] >= 0, "stops belong to joints");
        const double done = effort * (end.joint_position[i] - begin.joint_position[i]);
        work.limit += done;
        work.positive += std::max(0.0, done);
    }
    return work;
}

}  // namespace cambrian
