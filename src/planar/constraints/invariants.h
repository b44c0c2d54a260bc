#pragma once

// Conditions that hold in every simulation; only assertions use them. A motion that diverges is no
// bug, so numbers that are not finite pass until the tick has ended.

#include "core/assert.h"
#include "planar/constraints/rows.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

// Whether a value is at least -slack; NaN passes.
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

// Whether the index is that of a body or of the ground.
inline bool is_body_or_ground(const PlanarModel& model, int body) {
    return body == -1 || is_body(model, body);
}

inline bool are_parents_before_children(const PlanarModel& model) {
    for (int i = 0; i < model.body_count; ++i) {
        if (model.parent[i] >= i) return false;
    }
    return true;
}

// Whether normal and limit rows only push.
inline bool do_only_push(const ConstraintSystem& rows) {
    for (int row = 0; row < rows.count; ++row) {
        if (rows[row].kind != RowKind::kFriction && rows.impulse[row] < 0.0) return false;
    }
    return true;
}

// Whether friction is within its cone.
inline bool are_in_cones(const ConstraintSystem& rows, double friction) {
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
