// The points are searched outwards from a point in the order of their first measure. The search
// ends where that measure alone differs by more than the distance of the farthest neighbour found
// (J. Friedman, F. Baskett and L. Shustek, An Algorithm for Finding Nearest Neighbors, 1975).

#include "evolution/selections/nearest_neighbors.h"

#include "core/assert.h"
#include "math/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cambrian {
namespace {

constexpr double kRounding = 1.0 - 1e-12;  // a distance may be rounded below one of its measures

}  // namespace

NeighborSearch::NeighborSearch(std::span<const Point> points)
    : points_(points), order_(points.size()), group_of_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return points_[a] < points_[b]; });
    for (std::size_t place = 0; place < order_.size(); ++place) {
        const bool same = place > 0 && points_[order_[place]] == points_[order_[place - 1]];
        if (!same) groups_.push_back({place, place});
        groups_.back().end = place + 1;
        group_of_[order_[place]] = groups_.size() - 1;
    }
}

void NeighborSearch::consider(const Group& group, std::size_t point, std::size_t count) {
    const double away = distance(points_[point], of(group));
    for (std::size_t place = group.begin; place < group.end; ++place) {
        const Neighbor candidate{away, order_[place]};
        if (nearest_.size() == count && !(candidate < nearest_.back())) return;
        if (candidate.point != point) insert(candidate, count);
    }
}

void NeighborSearch::insert(const Neighbor& candidate, std::size_t count) {
    if (nearest_.size() == count) nearest_.pop_back();
    nearest_.insert(std::upper_bound(nearest_.begin(), nearest_.end(), candidate), candidate);
}

std::span<const Neighbor> NeighborSearch::nearest(std::size_t point, std::size_t count) {
    CAMBRIAN_ASSERT(point < points_.size() && count < points_.size(), "so many others exist");
    nearest_.clear();
    if (count == 0) return nearest_;
    const std::size_t own = group_of_[point];
    consider(groups_[own], point, count);
    const auto gap_to = [&](std::size_t group) {
        return std::fabs(of(groups_[group])[0] - points_[point][0]);
    };
    std::size_t below = own;      // one past the next group below
    std::size_t above = own + 1;  // the next group above
    while (below > 0 || above < groups_.size()) {
        constexpr double none = std::numeric_limits<double>::infinity();
        const double gap_below = below > 0 ? gap_to(below - 1) : none;
        const double gap_above = above < groups_.size() ? gap_to(above) : none;
        const double gap = std::min(gap_below, gap_above);
        if (nearest_.size() == count && gap * kRounding > nearest_.back().distance) break;
        consider(groups_[gap_below <= gap_above ? --below : above++], point, count);
    }
    return nearest_;
}

}  // namespace cambrian
