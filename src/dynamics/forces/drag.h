#pragma once

// Drag of the medium on the faces of the boxes (dynamics/README.md 7).

#include "dynamics/articulated/articulated_body.h"
#include "dynamics/model/forcing.h"

namespace cambrian {

// Adds the drag to the loads and returns its power, W (never positive).
double add_drag(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                Loads& loads);

}  // namespace cambrian
