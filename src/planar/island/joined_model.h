#pragma once

// The model of several creatures, one behind the other.

#include "planar/model/planar_model.h"

#include <span>

namespace cambrian {

// The counts of the models together must be within the limits of planar_model.h.
// Boxes of different members may touch.
PlanarModel join_models(std::span<const PlanarModel* const> members);

}  // namespace cambrian
