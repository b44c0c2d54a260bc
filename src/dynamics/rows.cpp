#include "dynamics/rows.h"

#include "dynamics/loop_closure.h"
#include "dynamics/row_matrix.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kHeldShare = 0.02;  // of a row's coupling without loops, the least that is left

struct BodyMotion {
    const PerBody& x;
    const PerBody& y;
    const PerBody& spin;
    const PerCoordinate& coordinate;
};

CAMBRIAN_INLINE double row_rate(const PlanarModel& model, const RowSystem& rows, int row,
                                const BodyMotion& motion) {
    const int a = rows.body_a[row];
    if (rows.kind[row] == RowKind::kLimit) {
        double rate = motion.coordinate[a];
        if (model.joint[a] == JointType::kRotary) rate -= motion.spin[model.parent[a]];
        return rows.dir_x[row] * rate;
    }
    double rate = rows.dir_x[row] * motion.x[a] + rows.dir_y[row] * motion.y[a] +
                  rows.moment_a[row] * motion.spin[a];
    const int b = rows.body_b[row];
    if (b >= 0)
        rate -= rows.dir_x[row] * motion.x[b] + rows.dir_y[row] * motion.y[b] +
                rows.moment_b[row] * motion.spin[b];
    return rate;
}

// J' v: the turning of the arms, and of the direction with body b while a slides along it.
CAMBRIAN_INLINE double turning(const RowSystem& rows, int row, const Contact& c,
                               const Kinematics& k) {
    const int a = c.body_a;
    const int b = c.body_b;
    const double x = rows.dir_x[row];
    const double y = rows.dir_y[row];
    const double arms = -k.spin[a] * k.spin[a] * (x * c.arm_ax + y * c.arm_ay);
    if (b < 0) return arms;
    const double sliding_x =
        k.velocity_x[a] - k.spin[a] * c.arm_ay - k.velocity_x[b] + k.spin[b] * c.arm_by;
    const double sliding_y =
        k.velocity_y[a] + k.spin[a] * c.arm_ax - k.velocity_y[b] - k.spin[b] * c.arm_bx;
    return arms + k.spin[b] * k.spin[b] * (x * c.arm_bx + y * c.arm_by) +
           2.0 * k.spin[b] * (x * sliding_y - y * sliding_x);
}

CAMBRIAN_INLINE void set_contact_row(const Contact& c, int source, int row, RowSystem& rows) {
    const bool normal = rows.kind[row] == RowKind::kNormal;
    rows.source[row] = source;
    rows.friction_of[row] = -1;
    rows.body_a[row] = c.body_a;
    rows.body_b[row] = c.body_b;
    rows.dir_x[row] = normal ? c.normal_x : -c.normal_y;
    rows.dir_y[row] = normal ? c.normal_y : c.normal_x;
    rows.moment_a[row] = c.arm_ax * rows.dir_y[row] - c.arm_ay * rows.dir_x[row];
    rows.moment_b[row] = c.arm_bx * rows.dir_y[row] - c.arm_by * rows.dir_x[row];
}

int add_row(RowKind kind, RowSystem& rows) {
    rows.kind[rows.count] = kind;
    return rows.count++;
}

// The friction row of a contact's group, which acts at its nearest contact.
int join_friction(const ContactSet& contacts, int source, RowSystem& rows) {
    const Contact& contact = contacts.items[source];
    for (int row = 0; row < rows.count; ++row) {
        if (rows.kind[row] != RowKind::kFriction) continue;
        const Contact& other = contacts.items[rows.source[row]];
        if (friction_group(other) != friction_group(contact)) continue;
        if (contact.gap < other.gap) set_contact_row(contact, source, row, rows);
        return row;
    }
    const int row = add_row(RowKind::kFriction, rows);
    set_contact_row(contact, source, row, rows);
    return row;
}

void add_limit_row(const LimitCandidate& limit, int source, RowSystem& rows) {
    const int row = add_row(RowKind::kLimit, rows);
    rows.source[row] = source;
    rows.friction_of[row] = -1;
    rows.body_a[row] = limit.body;
    rows.body_b[row] = -1;
    rows.dir_x[row] = limit.sign;
    rows.dir_y[row] = 0.0;
    rows.moment_a[row] = 0.0;
    rows.moment_b[row] = 0.0;
}

void add_rows(const RowSources& sources, RowSystem& rows) {
    rows.count = 0;
    for (int c = 0; c < sources.contacts.count; ++c) {
        const int row = add_row(RowKind::kNormal, rows);
        set_contact_row(sources.contacts.items[c], c, row, rows);
        if (sources.with_friction) rows.friction_of[row] = join_friction(sources.contacts, c, rows);
    }
    for (int l = 0; l < sources.limits.count; ++l)
        add_limit_row(sources.limits.items[l], l, rows);
}

CAMBRIAN_INLINE BodyMotion motion_of(const BodyResponse& response) {
    return {response.x, response.y, response.spin, response.coordinate};
}

// Takes from the matrix what the closing pins hold back: B A+ B', B the rates of the rows by unit
// impulses in the pins. As in the matrix itself, a row that the mechanism hardly lets move is made
// softer.
void hold_loops(const PlanarModel& model, const Frame& frame, RowSystem& rows) {
    const LoopClosure loops(model, frame.kinematics, frame.factors);
    const std::vector<BodyResponse>& units = loops.unit_responses();
    Eigen::MatrixXd effect(rows.count, static_cast<Eigen::Index>(units.size()));
    for (int row = 0; row < rows.count; ++row) {
        for (std::size_t pin = 0; pin < units.size(); ++pin)
            effect(row, static_cast<Eigen::Index>(pin)) =
                row_rate(model, rows, row, motion_of(units[pin]));
    }
    const Eigen::MatrixXd held = effect * loops.impulses(effect.transpose());
    for (int row = 0; row < rows.count; ++row) {
        const double open = rows.coupling(row, row);
        for (int column = 0; column < rows.count; ++column)
            rows.line(row)[column] -= held(row, column);
        const double softness = std::max(0.0, kHeldShare * open - rows.coupling(row, row));
        rows.regularization[row] += softness;
        rows.line(row)[row] += softness;
    }
}

}  // namespace

void build_rows(const PlanarModel& model, const Motion& motion, const Frame& frame,
                const RowSources& sources, RowSystem& rows) {
    add_rows(sources, rows);
    const Kinematics& k = frame.kinematics;
    const BodyMotion speeds{k.velocity_x, k.velocity_y, k.spin, motion.speed};
    const BodyMotion accelerations = motion_of(frame.response);
    for (int row = 0; row < rows.count; ++row) {
        rows.rate[row] = row_rate(model, rows, row, speeds);
        rows.acceleration[row] = row_rate(model, rows, row, accelerations);
        if (rows.kind[row] != RowKind::kLimit)
            rows.acceleration[row] +=
                turning(rows, row, sources.contacts.items[rows.source[row]], k);
    }
    compute_row_matrix(model, frame, sources.friction_softness, rows);
    if (!model.closing_pins.empty()) hold_loops(model, frame, rows);
}

void add_row_impulses(const RowSystem& rows, double scale, Loads& loads) {
    for (int row = 0; row < rows.count; ++row) {
        const double impulse = scale * rows.impulse[row];
        const int a = rows.body_a[row];
        if (rows.kind[row] == RowKind::kLimit) {
            loads.effort[a] += rows.dir_x[row] * impulse;
            continue;
        }
        loads.force_x[a] += rows.dir_x[row] * impulse;
        loads.force_y[a] += rows.dir_y[row] * impulse;
        loads.torque[a] += rows.moment_a[row] * impulse;
        const int b = rows.body_b[row];
        if (b < 0) continue;
        loads.force_x[b] -= rows.dir_x[row] * impulse;
        loads.force_y[b] -= rows.dir_y[row] * impulse;
        loads.torque[b] -= rows.moment_b[row] * impulse;
    }
}

}  // namespace cambrian
