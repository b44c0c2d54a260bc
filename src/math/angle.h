#pragma once

#include "math/elementary.h"

#include <cmath>

namespace cambrian {

// Returns the angle in [-pi, pi) with the same direction.
inline double wrap_angle(double angle) {
    const double wrapped = angle - 2 * kPi * std::floor((angle + kPi) / (2 * kPi));
    // Near half a turn, rounding may give a value outside the range.
    return wrapped < -kPi || wrapped >= kPi ? -kPi : wrapped;
}
inline constexpr double to_degrees(double radians) {
    return radians * (180.0 / kPi);
}
inline constexpr double to_radians(double degrees) {
    return degrees * (kPi / 180.0);
}

// Returns sine and cosine of an angle in degrees, exact at quarter turns.
inline SineCosine sine_cosine_of_degrees(double degrees) {
    const double quarters = std::nearbyint(degrees / 90.0);
    const SineCosine rest = sine_cosine(to_radians(degrees - 90.0 * quarters));
    const double quadrant = quarters - 4.0 * std::floor(0.25 * quarters);
    if (quadrant == 0.0) return rest;
    if (quadrant == 1.0) return {rest.cosine, -rest.sine};
    if (quadrant == 2.0) return {-rest.sine, -rest.cosine};
    return {-rest.cosine, rest.sine};
}

}  // namespace cambrian
