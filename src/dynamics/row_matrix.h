#pragma once

#include "dynamics/rows.h"

namespace cambrian {

// Fills the coupling matrix and its regularization from the factored trees.
void compute_row_matrix(const PlanarModel& model, const Frame& frame, RowSystem& rows);

}  // namespace cambrian
