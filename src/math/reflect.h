#pragma once

#include <algorithm>
#include <cmath>

namespace cambrian {

// x mirrored back at the bounds until it is inside [low, high]; used instead of clamping so that
// values do not pile up on a bound. low <= high; x finite.
inline double reflect(double x, double low, double high) {
    const double width = high - low;
    if (!(width > 0.0)) return low;
    double phase = std::fmod(x - low, 2.0 * width);
    if (phase < 0.0) phase += 2.0 * width;
    const double inside = phase <= width ? low + phase : low + (2.0 * width - phase);
    return std::clamp(inside, low, high);
}

}  // namespace cambrian
