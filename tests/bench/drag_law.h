#pragma once

// The drag of our physics on one rectangle, for engines without such a force.

#include "bench/bench_engine.h"
#include "math/types.h"
#include "world/environment.h"

namespace cambrian::bench {

struct PlanarWrench {
    double force_x = 0.0, force_y = 0.0;  // N, world
    double torque = 0.0;                  // N m, about the centre
};

PlanarWrench drag_on(const PartMotion& part, const Vec3& half_extents,
                     const Environment& environment);

inline bool has_drag(const Environment& environment) {
    return environment.viscosity_linear > 0.0 || environment.viscosity_quadratic > 0.0;
}

}  // namespace cambrian::bench
