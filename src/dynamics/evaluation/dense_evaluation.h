#pragma once

// The right-hand side of the motion in dense form (dense_form.h).

#include "dynamics/evaluation/accelerations.h"

namespace cambrian {

// Whether the dense form can evaluate this: nothing is held or pulled.
inline bool is_dense(const PlanarModel& model, const Forcing& forcing) {
    return model.dense.blocks > 0 && forcing.held == nullptr && !forcing.pulled &&
           model.closing_pins.empty();
}

// As evaluate_accelerations, but for the frame: its kinematics lack the geometry of the joints, it
// is not factored and its response has only coordinates and spins (find_centers, complete_frame).
// Where motors are implicit it has the inverse mass matrix.
void evaluate_dense(const PlanarModel& model, const Forcing& forcing, const Motion& motion,
                    const EvaluationPoint& point, Frame& frame, MotionRate& rate);

}  // namespace cambrian
