#pragma once

// Resistance of the medium against the boxes' faces (physics.md 6).

#include "dynamics/articulated/elimination.h"
#include "dynamics/model/forcing.h"

namespace cambrian {

// Adds the drag to the loads and returns its power, W (never positive).
double add_drag(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                Loads& loads);

}  // namespace cambrian
