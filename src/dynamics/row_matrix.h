#pragma once

#include "dynamics/rows.h"

namespace cambrian {

// Fills the coupling matrix and its regularization: four columns at a time through the factored
// tree.
void compute_row_matrix(const PlanarModel& model, const Frame& frame, RowSystem& rows);

}  // namespace cambrian
