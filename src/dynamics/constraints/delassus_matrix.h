#pragma once

#include "dynamics/constraints/rows.h"

namespace cambrian {

// Fills the Delassus matrix and its regularisation (dynamics/README.md 9) from the factors of the
// trees or from the inverse of the dense form. friction_softness: of friction rows, relative to the
// diagonal element of the same bodies without joints.
void compute_delassus_matrix(const PlanarModel& model, const EvaluationCache& cache,
                             double friction_softness, ConstraintSystem& rows);

}  // namespace cambrian
