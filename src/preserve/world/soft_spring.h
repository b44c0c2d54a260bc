#pragma once

// The damped spring of walls and of crowded bodies (preserve/README.md 2 and 9).

namespace cambrian {

// Returns the force for each kilogram (N/kg) at this depth (m) and speed of leaving (m/s); it is
// evaluated at the start of a tick and constant during it.
inline double spring_force(double depth, double leaving) {
    return 400.0 * depth - 20.0 * leaving;
}

}  // namespace cambrian
