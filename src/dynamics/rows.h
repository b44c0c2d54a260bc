#pragma once

// Unilateral velocity rows of contacts and joint limits, with the exact joint-space matrix that
// couples them (physics.md 7.2): rate after = rate before + matrix * impulse.

#include "dynamics/accelerations.h"
#include "dynamics/contact.h"

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

struct RowSystem {
    int count = 0;
    int stride = 0;  // of the matrix, doubles
    RowKind kind[kMaxRows];
    int source[kMaxRows];  // index of the contact or limit
    int normal[kMaxRows];  // friction rows: their normal row
    // Wrench of a unit impulse on bodies a and b (contacts), or joint and sign (limits).
    int body_a[kMaxRows], body_b[kMaxRows];
    double dir_x[kMaxRows], dir_y[kMaxRows], moment_a[kMaxRows], moment_b[kMaxRows];
    double rate[kMaxRows];            // J v
    double acceleration[kMaxRows];    // J a + J' v without contact
    double regularization[kMaxRows];  // included in the matrix's diagonal
    double impulse[kMaxRows];
    alignas(64) double matrix[kMaxRows * kMaxRows];

    double coupling(int row, int column) const { return matrix[row * stride + column]; }
};

// Rows of all contacts (with friction rows if there is friction) and limits, with rates and
// contact-free accelerations taken from the frame. Impulses are left unset.
void build_rows(const PlanarModel& model, const Motion& motion, const Frame& frame,
                const ContactSet& contacts, const LimitCandidate* limits, int limit_count,
                bool with_friction, RowSystem& rows);

// Adds impulse * scale of every row to the loads.
void add_row_impulses(const RowSystem& rows, double scale, Loads& loads);

// matrix * impulse for one row, without regularization.
double impulse_effect(const RowSystem& rows, int row);

}  // namespace cambrian
