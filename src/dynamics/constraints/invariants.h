#pragma once

// What must hold inside a simulation whatever creatures do. Only assertions ask for it. A motion
// that diverges is no bug: numbers that are not finite count as sound until a tick has ended.

#include "core/assert.h"
#include "dynamics/constraints/rows.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

// Not below 0, beyond rounding; not a number is let pass.
inline bool is_not_negative(double value, double slack = 0.0) {
    return !(value < -slack);
}

inline bool are_finite(const double* values, int count) {
    return std::all_of(values, values + count, [](double value) { return std::isfinite(value); });
}

inline bool is_finite(const PlanarModel& model, const Motion& motion) {
    return are_finite(motion.position, coordinate_count(model)) &&
           are_finite(motion.speed, coordinate_count(model));
}

inline bool is_body(const PlanarModel& model, int body) {
    return body >= 0 && body < model.body_count;
}

// A body or the ground.
inline bool is_body_or_ground(const PlanarModel& model, int body) {
    return body == -1 || is_body(model, body);
}

inline bool are_parents_before_children(const PlanarModel& model) {
    for (int i = 0; i < model.body_count; ++i) {
        if (model.parent[i] >= i) return false;
    }
    return true;
}

// Normal and limit rows only push.
inline bool do_only_push(const RowSystem& rows) {
    for (int row = 0; row < rows.count; ++row) {
        if (rows[row].kind != RowKind::kFriction && rows.impulse[row] < 0.0) return false;
    }
    return true;
}

// Friction is at most its share of the normal impulses that load it.
inline bool are_in_cones(const RowSystem& rows, double friction) {
    double load[kMaxRows] = {};
    for (int row = 0; row < rows.count; ++row) {
        if (rows[row].friction_of >= 0) load[rows[row].friction_of] += rows.impulse[row];
    }
    for (int row = 0; row < rows.count; ++row) {
        if (rows[row].kind != RowKind::kFriction) continue;
        if (std::fabs(rows.impulse[row]) > friction * load[row] * (1.0 + 1e-9) + 1e-12)
            return false;
    }
    return true;
}

}  // namespace cambrian
