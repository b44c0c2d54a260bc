#pragma once

// Drag of models with stretches (dynamics/README.md 20). Opposite faces of a part that stretches do
// not see the same speed, so all four are integrated; where a face leads, its outward normal speed
// w is positive and the medium presses with k1 w + k2 w^2 on it.

#include "dynamics/articulated/articulated_body.h"
#include "dynamics/model/forcing.h"

namespace cambrian {

// Does what add_drag does.
double add_stretched_drag(const PlanarModel& model, const Medium& medium,
                          const Kinematics& kinematics, Loads& loads);

}  // namespace cambrian
