#pragma once

// The range of signals between neurons (brain/README.md 1).

#include <cmath>

namespace cambrian {

inline constexpr double kSignalLimit = 10.0;  // inputs and outputs stay within +- this

// x within +-10; not a number becomes 0.
inline double limit_signal(double x) {
    return std::isnan(x) ? 0.0 : std::fmin(std::fmax(x, -kSignalLimit), kSignalLimit);
}

// Truth is +1, falsehood -1, as a contact sensor reads.
inline double truth(bool value) {
    return value ? 1.0 : -1.0;
}

}  // namespace cambrian
