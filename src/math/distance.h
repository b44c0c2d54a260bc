#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace cambrian {

// Returns the Euclidean distance of two points.
template <std::size_t Measures>
double distance(const std::array<double, Measures>& a, const std::array<double, Measures>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < Measures; ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

}  // namespace cambrian
