#pragma once

// The matrix that couples rows, from the inverse mass matrix of the dense form (dense_form.h).

#include "dynamics/constraints/rows.h"

namespace cambrian {

// As the matrix that compute_row_matrix fills from the factored trees, without regularization. The
// frame must have its inverse and the rows their stride.
void fill_dense_row_matrix(const PlanarModel& model, const Frame& frame, RowSystem& rows);

}  // namespace cambrian
