#pragma once

#include "math/elementary.h"

#include <cmath>

namespace cambrian {

// The same direction in [-pi, pi).
inline double wrap_angle(double angle) {
    const double wrapped = angle - 2 * kPi * std::floor((angle + kPi) / (2 * kPi));
    // Beside half a turn the difference may round to the outside.
    return wrapped < -kPi || wrapped >= kPi ? -kPi : wrapped;
}
inline constexpr double to_degrees(double radians) {
    return radians * (180.0 / kPi);
}
inline constexpr double to_radians(double degrees) {
    return degrees * (kPi / 180.0);
}

}  // namespace cambrian
