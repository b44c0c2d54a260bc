#pragma once

// The right-hand side of the equations of motion in dense form (dense_form.h).

#include "dynamics/evaluation/accelerations.h"

namespace cambrian {

// Whether the dense form applies: no contact forces and no pull.
inline bool is_dense(const PlanarModel& model, const Forcing& forcing) {
    return model.dense.blocks > 0 && forcing.held == nullptr && forcing.pulls.empty();
}

// Does what evaluate_accelerations does, with an incomplete cache: it has no geometry of the
// joints, no factors, and a response of coordinates and spins only (find_centers, complete_cache).
// With implicit motors it has the inverse mass matrix.
void evaluate_dense(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                    const EvaluationPoint& point, EvaluationCache& cache, MotionRate& rate);

}  // namespace cambrian
