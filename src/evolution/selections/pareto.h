#pragma once

// Sorting by two objectives at once, both better when larger.

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

struct ParetoPoint {
    double first = 0.0;
    double second = 0.0;
};

// Indices of the points by non-dominated front, then by crowding distance within a front (Deb et
// al. 2002, NSGA-II): the extremes of a front first, then those in emptier places. Equals keep
// their order. A point dominates another if it is nowhere worse and somewhere better.
std::vector<std::size_t> pareto_order(std::span<const ParetoPoint> points);

// The front of each point; 0 is dominated by none.
std::vector<std::size_t> pareto_fronts(std::span<const ParetoPoint> points);

}  // namespace cambrian
