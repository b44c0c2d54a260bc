#pragma once

// Non-dominated sorting by two objectives; larger is better for both.

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

struct ParetoPoint {
    double first = 0.0;
    double second = 0.0;
};

// Returns the indices of the points by non-dominated front, and within a front by crowding distance
// (Deb et al. 2002, NSGA-II): first the extremes, then points in sparser places. Equal points keep
// their order. A point dominates another if it is nowhere worse and somewhere better.
std::vector<std::size_t> pareto_order(std::span<const ParetoPoint> points);

// Returns the front of each point; points of front 0 are not dominated.
std::vector<std::size_t> pareto_fronts(std::span<const ParetoPoint> points);

}  // namespace cambrian
