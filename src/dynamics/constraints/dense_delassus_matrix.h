#pragma once

// The Delassus matrix from the inverse mass matrix of the dense form (dense_form.h).

#include "dynamics/constraints/rows.h"

namespace cambrian {

// Fills the same matrix as compute_delassus_matrix does from the factors, without regularisation.
// The cache must have its inverse and the rows their stride.
void fill_dense_delassus_matrix(const PlanarModel& model, const EvaluationCache& cache,
                                ConstraintSystem& rows);

}  // namespace cambrian
