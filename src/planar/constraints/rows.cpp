#include "planar/constraints/rows.h"

#include "planar/constraints/invariants.h"
#include "planar/model/stretching.h"

#include <algorithm>

namespace cambrian {
namespace {

struct Planar {
    double x, y;  // m/s or m/s^2
};

// A contact at the positions of a cache, and the relative motion of its two points.
struct PlacedContact {
    double normal_x, normal_y;  // unit
    double arm_ax, arm_ay, arm_bx, arm_by;
    double sliding;       // m/s, of a's point against b's, where the contact was collected
    Planar acceleration;  // the same without contact, along directions that turn with body b
};

CAMBRIAN_INLINE double row_rate(const PlanarModel& model, const Row& row,
                                const BodyResponse& motion) {
    const int a = row.body_a;
    if (row.kind == RowKind::kLimit) {
        double rate = motion.coordinate[a];
        if (model.motion[a] == JointMotion::kTurn) rate -= motion.spin[model.parent[a]];
        return row.dir_x * rate;
    }
    double rate = row.dir_x * motion.x[a] + row.dir_y * motion.y[a] + row.moment_a * motion.spin[a];
    const int b = row.body_b;
    if (b >= 0)
        rate -= row.dir_x * motion.x[b] + row.dir_y * motion.y[b] + row.moment_b * motion.spin[b];
    return rate;
}

// The rate of a row by the stretches of its bodies.
double stretches_rate(const ConstraintSystem& rows, int row, const BodyResponse& motion) {
    double rate = 0.0;
    if (!rows.deforms || rows[row].kind == RowKind::kLimit) return rate;
    const RowStretches& stretches = rows.stretches[row];
    if (stretches.slot_a >= 0) rate += stretches.effort_a * motion.coordinate[stretches.slot_a];
    if (stretches.slot_b >= 0) rate -= stretches.effort_b * motion.coordinate[stretches.slot_b];
    return rate;
}

// Moves a contact with its material point of body a and turns its normal with body b.
CAMBRIAN_INLINE void move_contact(const Contact& contact, const Kinematics& from,
                                  const Kinematics& to, PlacedContact& placed) {
    const int a = contact.body_a;
    const int b = contact.body_b;
    placed.arm_ax = to.cosine[a] * contact.point_x - to.sine[a] * contact.point_y;
    placed.arm_ay = to.sine[a] * contact.point_x + to.cosine[a] * contact.point_y;
    if (b < 0) return;
    placed.arm_bx = to.x[a] + placed.arm_ax - to.x[b];
    placed.arm_by = to.y[a] + placed.arm_ay - to.y[b];
    const double cosine = to.cosine[b] * from.cosine[b] + to.sine[b] * from.sine[b];
    const double sine = to.sine[b] * from.cosine[b] - to.cosine[b] * from.sine[b];
    placed.normal_x = cosine * contact.normal_x - sine * contact.normal_y;
    placed.normal_y = sine * contact.normal_x + cosine * contact.normal_y;
}

CAMBRIAN_INLINE Planar point_velocity(const Kinematics& k, int body, double arm_x, double arm_y) {
    return {k.velocity_x[body] - k.spin[body] * arm_y, k.velocity_y[body] + k.spin[body] * arm_x};
}

CAMBRIAN_INLINE Planar point_acceleration(const EvaluationCache& cache, int body, double arm_x,
                                          double arm_y) {
    const double spin = cache.kinematics.spin[body];
    const double turn = cache.response.spin[body];
    return {cache.response.x[body] - turn * arm_y - spin * spin * arm_x,
            cache.response.y[body] + turn * arm_x - spin * spin * arm_y};
}

CAMBRIAN_INLINE Planar difference(const Planar& a, const Planar& b) {
    return {a.x - b.x, a.y - b.y};
}

// J a + J' v of both directions: the points' accelerations, and the turning of the directions with
// body b while a slides along it.
CAMBRIAN_INLINE Planar relative_acceleration(const Contact& contact, const PlacedContact& placed,
                                             const EvaluationCache& cache) {
    const int a = contact.body_a;
    const int b = contact.body_b;
    const Planar of_a = point_acceleration(cache, a, placed.arm_ax, placed.arm_ay);
    if (b < 0) return of_a;
    const Planar of_b = point_acceleration(cache, b, placed.arm_bx, placed.arm_by);
    const Planar sliding =
        difference(point_velocity(cache.kinematics, a, placed.arm_ax, placed.arm_ay),
                   point_velocity(cache.kinematics, b, placed.arm_bx, placed.arm_by));
    const double turn = 2.0 * cache.kinematics.spin[b];
    return {of_a.x - of_b.x + turn * sliding.y, of_a.y - of_b.y - turn * sliding.x};
}

// The relative speed along the tangent, the normal turned by a quarter to the left.
CAMBRIAN_INLINE double sliding_speed(const Contact& contact, const Kinematics& k) {
    Planar velocity = point_velocity(k, contact.body_a, contact.arm_ax, contact.arm_ay);
    if (contact.body_b >= 0)
        velocity =
            difference(velocity, point_velocity(k, contact.body_b, contact.arm_bx, contact.arm_by));
    return contact.normal_x * velocity.y - contact.normal_y * velocity.x;
}

CAMBRIAN_INLINE void place_contact(const Contact& contact, const Kinematics& detected,
                                   const EvaluationCache& cache, PlacedContact& placed) {
    placed.normal_x = contact.normal_x;
    placed.normal_y = contact.normal_y;
    placed.arm_ax = contact.arm_ax;
    placed.arm_ay = contact.arm_ay;
    placed.arm_bx = contact.arm_bx;
    placed.arm_by = contact.arm_by;
    placed.sliding = sliding_speed(contact, detected);
    if (&detected != &cache.kinematics) move_contact(contact, detected, cache.kinematics, placed);
    placed.acceleration = relative_acceleration(contact, placed, cache);
}

// The acceleration that a body's stretch adds to a point at this world offset.
Simd2d stretch_acceleration(const PlanarModel& model, const EvaluationCache& cache, int body,
                            double arm_x, double arm_y) {
    const int slot = model.stretch_slot[body];
    if (slot < 0) return Simd2d{};
    const Kinematics& k = cache.kinematics;
    return both(cache.response.coordinate[slot]) * stretch_lever(k, body, arm_x, arm_y) +
           stretch_bias(k, body, arm_x, arm_y);
}

// Does the same with deformable bodies. The growth of b along a's way changes the rate of the
// tangent as well.
[[gnu::noinline]] void place_stretched_contact(const PlanarModel& model, const Contact& contact,
                                               const Kinematics& detected,
                                               const EvaluationCache& cache,
                                               PlacedContact& placed) {
    const int a = contact.body_a;
    const int b = contact.body_b;
    const Kinematics& k = cache.kinematics;
    Contact present = contact;
    stretch_point(k, a, present.point_x, present.point_y);
    place_contact(present, detected, cache, placed);
    Simd2d before = stretch_velocity(detected, a, contact.arm_ax, contact.arm_ay);
    Simd2d added = stretch_acceleration(model, cache, a, placed.arm_ax, placed.arm_ay);
    if (b >= 0) {
        before -= stretch_velocity(detected, b, contact.arm_bx, contact.arm_by);
        added -= stretch_acceleration(model, cache, b, placed.arm_bx, placed.arm_by);
        const Simd2d stretching = stretch_velocity(k, a, placed.arm_ax, placed.arm_ay) -
                                  stretch_velocity(k, b, placed.arm_bx, placed.arm_by);
        const Planar rigid = difference(point_velocity(k, a, placed.arm_ax, placed.arm_ay),
                                        point_velocity(k, b, placed.arm_bx, placed.arm_by));
        const double turn = 2.0 * k.spin[b];
        added += both(turn) * Simd2d{stretching[1], -stretching[0]} -
                 stretch_velocity(k, b, rigid.x + stretching[0], rigid.y + stretching[1]);
    }
    placed.sliding += contact.normal_x * before[1] - contact.normal_y * before[0];
    placed.acceleration.x += added[0];
    placed.acceleration.y += added[1];
}

CAMBRIAN_INLINE void set_contact_row(const Contact& contact, const PlacedContact& placed,
                                     Row& row) {
    const bool normal = row.kind == RowKind::kNormal;
    const double x = normal ? placed.normal_x : -placed.normal_y;
    const double y = normal ? placed.normal_y : placed.normal_x;
    row.body_a = static_cast<std::int16_t>(contact.body_a);
    row.body_b = static_cast<std::int16_t>(contact.body_b);
    row.dir_x = x;
    row.dir_y = y;
    row.moment_a = placed.arm_ax * y - placed.arm_ay * x;
    row.moment_b = placed.arm_bx * y - placed.arm_by * x;
    row.rate = normal ? -contact.closing_speed : placed.sliding;
    row.acceleration = x * placed.acceleration.x + y * placed.acceleration.y;
}

// Finds what a contact's row does to the stretches of its bodies.
RowStretches find_stretches(const PlanarModel& model, const Kinematics& k, const Row& row,
                            const PlacedContact& placed) {
    RowStretches stretches;
    const Simd2d direction = {row.dir_x, row.dir_y};
    stretches.slot_a = model.stretch_slot[row.body_a];
    if (stretches.slot_a >= 0)
        stretches.effort_a =
            dot(direction, stretch_lever(k, row.body_a, placed.arm_ax, placed.arm_ay));
    if (row.body_b < 0) return stretches;
    stretches.slot_b = model.stretch_slot[row.body_b];
    if (stretches.slot_b >= 0)
        stretches.effort_b =
            dot(direction, stretch_lever(k, row.body_b, placed.arm_bx, placed.arm_by));
    return stretches;
}

// Adds the efforts of the contacts' rows on stretches.
[[gnu::noinline]] void add_stretch_impulses(const ConstraintSystem& rows, const double* impulses,
                                            double scale, Loads& loads) {
    for (int r = 0; r < rows.count; ++r) {
        if (rows[r].kind == RowKind::kLimit || impulses[r] == 0.0) continue;
        const RowStretches& stretches = rows.stretches[r];
        const double impulse = scale * impulses[r];
        if (stretches.slot_a >= 0) loads.effort[stretches.slot_a] += stretches.effort_a * impulse;
        if (stretches.slot_b >= 0) loads.effort[stretches.slot_b] -= stretches.effort_b * impulse;
    }
}

Row& add_row(RowKind kind, int source, ConstraintSystem& rows) {
    CAMBRIAN_TICK_ASSERT(rows.count < kMaxRows, "rows have room");
    Row& row = rows[rows.count++];
    row.kind = kind;
    row.source = static_cast<std::int16_t>(source);
    row.friction_of = -1;
    return row;
}

// Finds or adds the friction row of each contact's group. It acts at the nearest contact.
class FrictionRows {
public:
    FrictionRows(const ContactSet& contacts, ConstraintSystem& rows)
        : contacts_(contacts), rows_(rows) {
        for (std::int16_t& row : of_body_)
            row = -1;
    }

    // Returns the row of the contact's group.
    std::int16_t join(int source) {
        CAMBRIAN_TICK_ASSERT(source >= 0 && source < contacts_.count, "a contact of the set");
        const Contact& contact = contacts_.items[source];
        std::int16_t& known = is_on_ground(contact) ? of_body_[contact.body_a] : of_pair_;
        if (!is_on_ground(contact) && friction_group(contact) != pair_) {
            pair_ = friction_group(contact);
            known = -1;
        }
        if (known < 0) {
            known = static_cast<std::int16_t>(rows_.count);
            add_row(RowKind::kFriction, source, rows_);
        } else if (contact.gap < contacts_.items[rows_[known].source].gap) {
            rows_[known].source = static_cast<std::int16_t>(source);
        }
        return known;
    }

private:
    const ContactSet& contacts_;
    ConstraintSystem& rows_;
    // On the ground; -1: none. Room for complete vectors makes it fast to fill.
    std::int16_t of_body_[(kMaxBodies + 15) / 16 * 16];
    std::int16_t of_pair_ = -1;  // of the pair seen last, whose contacts follow each other
    int pair_ = -1;
};

void list_contact_rows(const RowSources& sources, ConstraintSystem& rows) {
    FrictionRows frictions(sources.contacts, rows);
    for (int c = 0; c < sources.contacts.count; ++c) {
        Row& row = add_row(RowKind::kNormal, c, rows);
        if (sources.with_friction) row.friction_of = frictions.join(c);
    }
}

void add_limit_rows(const PlanarModel& model, const LimitSet& limits, const Kinematics& detected,
                    const BodyResponse& accelerations, ConstraintSystem& rows) {
    // A stop for which there is no room is passed by a little; the next step brings it back.
    for (int l = 0; l < limits.count && rows.count < kMaxRows; ++l) {
        const LimitCandidate& limit = limits.items[l];
        CAMBRIAN_TICK_ASSERT(limit.sign == 1.0 || limit.sign == -1.0, "one of two stops");
        CAMBRIAN_TICK_ASSERT(is_body(model, limit.body) && model.parent[limit.body] >= 0,
                             "stops belong to joints");
        Row& row = add_row(RowKind::kLimit, l, rows);
        row.body_a = static_cast<std::int16_t>(limit.body);
        row.body_b = -1;
        row.dir_x = limit.sign;
        row.dir_y = 0.0;
        row.moment_a = 0.0;
        row.moment_b = 0.0;
        row.rate = limit.sign * detected.joint_rate[limit.body];
        row.acceleration = row_rate(model, row, accelerations);
    }
}

}  // namespace

void build_rows(const PlanarModel& model, const RowSources& sources, const Kinematics& detected,
                const EvaluationCache& cache, ConstraintSystem& rows) {
    CAMBRIAN_TICK_ASSERT(sources.contacts.count <= kMaxContacts, "contacts have room");
    PlacedContact placed[kMaxContacts];
    rows.deforms = model.stretch_count > 0;
    for (int c = 0; c < sources.contacts.count; ++c) {
        if (rows.deforms)
            place_stretched_contact(model, sources.contacts.items[c], detected, cache, placed[c]);
        else
            place_contact(sources.contacts.items[c], detected, cache, placed[c]);
    }
    rows.count = 0;
    list_contact_rows(sources, rows);
    for (int r = 0; r < rows.count; ++r) {
        Row& row = rows[r];
        set_contact_row(sources.contacts.items[row.source], placed[row.source], row);
        CAMBRIAN_TICK_ASSERT(is_body(model, row.body_a) && is_body_or_ground(model, row.body_b),
                             "a contact of bodies");
    }
    for (int r = 0; rows.deforms && r < rows.count; ++r)
        rows.stretches[r] =
            find_stretches(model, cache.kinematics, rows[r], placed[rows[r].source]);
    add_limit_rows(model, sources.limits, detected, cache.response, rows);
    compute_delassus_matrix(model, cache, sources.friction_softness, rows);
}

void rate_rows(const PlanarModel& model, const ConstraintSystem& rows,
               const BodyResponse (&motions)[2], double (&rates)[2][kMaxRows]) {
    for (int row = 0; row < rows.count; ++row) {
        for (int which = 0; which < 2; ++which)
            rates[which][row] = row_rate(model, rows[row], motions[which]);
    }
    if (!rows.deforms) return;
    for (int row = 0; row < rows.count; ++row) {
        for (int which = 0; which < 2; ++which)
            rates[which][row] += stretches_rate(rows, row, motions[which]);
    }
}

void add_row_impulses(const ConstraintSystem& rows, const double* impulses, double scale,
                      Loads& loads) {
    if (rows.deforms) add_stretch_impulses(rows, impulses, scale, loads);
    for (int r = 0; r < rows.count; ++r) {
        if (impulses[r] == 0.0) continue;
        const Row& row = rows[r];
        CAMBRIAN_TICK_ASSERT(r < kMaxRows, "a row of the system");
        const double impulse = scale * impulses[r];
        const int a = row.body_a;
        if (row.kind == RowKind::kLimit) {
            loads.effort[a] += row.dir_x * impulse;
            continue;
        }
        loads.force_x[a] += row.dir_x * impulse;
        loads.force_y[a] += row.dir_y * impulse;
        loads.torque[a] += row.moment_a * impulse;
        const int b = row.body_b;
        if (b < 0) continue;
        loads.force_x[b] -= row.dir_x * impulse;
        loads.force_y[b] -= row.dir_y * impulse;
        loads.torque[b] -= row.moment_b * impulse;
    }
}

}  // namespace cambrian
