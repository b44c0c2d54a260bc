#pragma once

#include "math/elementary.h"

#include <algorithm>

namespace cambrian {

// Returns the reading of a nose at a concentration: its logarithm, so that the difference of two
// noses is the same however strong the smell is.
inline double smell_reading(double concentration) {
    constexpr double kLeast = 1e-3;  // units; less is hardly noticed
    constexpr double kScale = 0.25;
    constexpr double kMost = 5.0;
    return std::min(kMost, kScale * logarithm(1.0 + concentration / kLeast));
}

}  // namespace cambrian
