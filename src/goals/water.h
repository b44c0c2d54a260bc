#pragma once

// The default medium of goals in water: weightless, without ground.

#include "world/environment.h"

namespace cambrian {

inline Environment water() {
    Environment environment;
    environment.gravity = 0.0;
    environment.has_ground = false;
    environment.viscosity_linear = 0.2;
    environment.viscosity_quadratic = 1.0;
    return environment;
}

}  // namespace cambrian
