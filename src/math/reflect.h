#pragma once

#include <algorithm>
#include <cmath>

namespace cambrian {

// Returns x reflected at the bounds until it is inside [low, high]. Unlike clamping, this does not
// accumulate values at a bound. Needs low <= high and a finite x.
inline double reflect(double x, double low, double high) {
    const double width = high - low;
    if (!(width > 0.0)) return low;
    double phase = std::fmod(x - low, 2.0 * width);
    if (phase < 0.0) phase += 2.0 * width;
    const double inside = phase <= width ? low + phase : low + (2.0 * width - phase);
    return std::clamp(inside, low, high);
}

}  // namespace cambrian
