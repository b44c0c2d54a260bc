#pragma once

// Statistics of samples, which must not be empty.

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace cambrian {

// For an even number of values, the median is the mean of the middle two.
inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

inline double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Returns the mean of the smaller half. The median of an odd number of values has half weight.
inline double mean_of_worse_half(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    double sum = values.size() % 2 == 0 ? 0.0 : 0.5 * values[half];
    for (std::size_t i = 0; i < half; ++i)
        sum += values[i];
    return sum / (0.5 * static_cast<double>(values.size()));
}

inline double greatest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

}  // namespace cambrian
