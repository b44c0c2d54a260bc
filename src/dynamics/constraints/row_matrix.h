#pragma once

#include "dynamics/constraints/rows.h"

namespace cambrian {

// Fills the coupling matrix and its regularization from the factored trees or the inverse
// of the dense form. The softness is that of
// friction rows, as a share of what couples a row to itself where no joint holds the bodies.
void compute_row_matrix(const PlanarModel& model, const Frame& frame, double friction_softness,
                        RowSystem& rows);

}  // namespace cambrian
