#pragma once

// Unilateral velocity rows of contacts and joint limits, with the exact joint-space matrix that
// couples them (physics.md 7.2): rate after = rate before + matrix * impulse.

#include "dynamics/accelerations.h"
#include "dynamics/contact.h"
#include "dynamics/lanes.h"

namespace cambrian {

inline constexpr int kMaxRows = 128;
static_assert(2 * kMaxContacts + kMaxBodies <= kMaxRows);

enum class RowKind : std::uint8_t { kNormal, kFriction, kLimit };

// A joint near one of its stops.
struct LimitCandidate {
    int body = 0;
    double sign = 1.0;  // +1 at the low stop, -1 at the high one
    double gap = 0.0;   // rad or m
};

struct LimitSet {
    int count = 0;
    LimitCandidate items[2 * kMaxBodies];

    void add(const LimitCandidate& limit) { items[count++] = limit; }
};

struct RowSystem {
    int count = 0;
    int stride = 0;  // of the matrix, doubles
    RowKind kind[kMaxRows];
    int source[kMaxRows];  // index of the contact or limit
    // Normal rows: the friction row they load, or -1. The contacts of one friction group share one.
    int friction_of[kMaxRows];
    // Wrench of a unit impulse on bodies a and b (contacts), or joint and sign (limits).
    int body_a[kMaxRows], body_b[kMaxRows];
    double dir_x[kMaxRows], dir_y[kMaxRows], moment_a[kMaxRows], moment_b[kMaxRows];
    double rate[kMaxRows];            // J v
    double acceleration[kMaxRows];    // J a + J' v without contact
    double regularization[kMaxRows];  // included in the matrix's diagonal
    double response[kMaxRows];        // regularized matrix times impulse, of the last solution
    // Zero beyond count, as are the columns of the matrix, up to the stride.
    double impulse[kMaxRows];
    double matrix[kMaxRows * kMaxRows];

    double* line(int row) { return matrix + std::ptrdiff_t{row} * stride; }
    const double* line(int row) const { return matrix + std::ptrdiff_t{row} * stride; }
    double coupling(int row, int column) const { return line(row)[column]; }
    // Regularized matrix times impulse, for one row.
    CAMBRIAN_INLINE double product(int row) const {
        return lane_product(line(row), impulse, stride);
    }
};

// What rows are made of.
struct RowSources {
    const ContactSet& contacts;
    const LimitSet& limits;
    bool with_friction = false;
    double friction_softness = 0.0;  // of friction rows, as a share of the free bodies' coupling
};

// Rows of all sources, with rates and contact-free accelerations taken from the frame. Impulses are
// left unset.
void build_rows(const PlanarModel& model, const Motion& motion, const Frame& frame,
                const RowSources& sources, RowSystem& rows);

// Adds impulse * scale of every row to the loads.
void add_row_impulses(const RowSystem& rows, double scale, Loads& loads);

// Change of a row's rate by the last solution, without regularization.
inline double impulse_effect(const RowSystem& rows, int row) {
    return rows.response[row] - rows.regularization[row] * rows.impulse[row];
}

}  // namespace cambrian
