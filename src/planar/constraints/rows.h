#pragma once

// Unilateral velocity constraints (rows) of contacts and joint limits, and the Delassus matrix that
// couples them (planar/README.md 9): rate after = rate before + matrix * impulse.

#include "dynamics/simd.h"
#include "planar/contact/contact.h"
#include "planar/evaluation/accelerations.h"

#include <cstdint>

namespace cambrian {

// All contacts, with friction, and one stop for each joint. A joint whose range is hardly wider
// than nothing has two; of more stops than there is room for, the last have no row.
inline constexpr int kMaxRows = 188;
static_assert(2 * kMaxContacts + kMaxBodies <= kMaxRows);

enum class RowKind : std::uint8_t { kNormal, kFriction, kLimit };

// A joint near one of its limits.
struct LimitCandidate {
    int body = 0;
    double sign = 1.0;  // +1 at the low limit, -1 at the high one
    double gap = 0.0;   // rad or m
};

struct LimitSet {
    int count = 0;
    LimitCandidate items[2 * kMaxBodies];

    void add(const LimitCandidate& limit) { items[count++] = limit; }
};

struct Row {
    RowKind kind;
    std::int16_t source;  // index of the contact or limit
    // Normal rows: the friction row that they bound, or -1. All contacts of a group share one.
    std::int16_t friction_of;
    // Contacts: wrench of a unit impulse on a and, reversed, on b (-1: ground). Limits: the joint
    // of body a, with the sign in dir_x.
    std::int16_t body_a, body_b;
    double dir_x, dir_y, moment_a, moment_b;
    double rate;            // J v
    double acceleration;    // J a + J' v without contact
    double regularization;  // included in the matrix's diagonal
};

// What a contact's row does to the stretches of its bodies, by their slots (-1: none): the effort
// of a unit impulse on a's and, reversed, on b's.
struct RowStretches {
    int slot_a = -1, slot_b = -1;
    double effort_a = 0.0, effort_b = 0.0;
};

struct ConstraintSystem {
    int count = 0;
    int stride = 0;  // of the matrix, doubles
    Row rows[kMaxRows];
    // Regularised matrix times impulse of the last solution, for rows with an impulse only.
    double response[kMaxRows];
    // 0 from count to the stride; so are the columns of the matrix.
    double impulse[kMaxRows];
    double matrix[kMaxRows * kMaxRows];
    bool deforms = false;              // whether the model has stretches
    RowStretches stretches[kMaxRows];  // of rows of contacts, if it has

    const Row& operator[](int row) const { return rows[row]; }
    Row& operator[](int row) { return rows[row]; }
    double* line(int row) { return matrix + std::ptrdiff_t{row} * stride; }
    const double* line(int row) const { return matrix + std::ptrdiff_t{row} * stride; }
    double coupling(int row, int column) const { return line(row)[column]; }
    // Regularised matrix times impulse, for one row.
    CAMBRIAN_INLINE double product(int row) const {
        return lane_product(line(row), impulse, stride);
    }
};

// The contacts and limits from which rows are built, detected at one state.
struct RowSources {
    const ContactSet& contacts;
    const LimitSet& limits;
    bool with_friction = false;
    double friction_softness = 0.0;  // of friction rows, as a share of the free bodies' coupling
};

// Builds the rows. Their rates are those of the state in which the sources were detected. Their
// accelerations without contact and their matrix are those of the cache, at the same state or a
// later one. Impulses are not set.
void build_rows(const PlanarModel& model, const RowSources& sources, const Kinematics& detected,
                const EvaluationCache& cache, ConstraintSystem& rows);

// Computes the rates of all rows under any two motions of the bodies.
void rate_rows(const PlanarModel& model, const ConstraintSystem& rows,
               const BodyResponse (&motions)[2], double (&rates)[2][kMaxRows]);

// Adds impulse * scale of every row to the loads.
void add_row_impulses(const ConstraintSystem& rows, const double* impulses, double scale,
                      Loads& loads);

// Change of a row's rate by the last solution, without regularisation.
inline double impulse_effect(const ConstraintSystem& rows, int row) {
    return rows.response[row] - rows[row].regularization * rows.impulse[row];
}

// Fills the Delassus matrix and its regularisation (planar/README.md 9) from the factors of the
// trees or from the inverse of the dense form. friction_softness: of friction rows, relative to the
// diagonal element of the same bodies without joints.
void compute_delassus_matrix(const PlanarModel& model, const EvaluationCache& cache,
                             double friction_softness, ConstraintSystem& rows);

// The Delassus matrix from the inverse mass matrix of the dense form (dense_form.h).

// Fills the same matrix as compute_delassus_matrix does from the factors, without regularisation.
// The cache must have its inverse and the rows their stride.
void fill_dense_delassus_matrix(const PlanarModel& model, const EvaluationCache& cache,
                                ConstraintSystem& rows);

}  // namespace cambrian
