#include "evolution/selections/pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace cambrian {
namespace {

std::vector<std::size_t> sorted_indices(std::size_t count, const auto& before) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), before);
    return order;
}

// Adds to the crowding distance of each member the gap between its neighbours along one objective.
void add_gaps(std::span<const ParetoPoint> points, std::vector<std::size_t> front,
              double ParetoPoint::*objective, std::vector<double>& crowding) {
    std::stable_sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
        return points[a].*objective > points[b].*objective;
    });
    const double range = points[front.front()].*objective - points[front.back()].*objective;
    crowding[front.front()] = std::numeric_limits<double>::infinity();
    crowding[front.back()] = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i + 1 < front.size() && range > 0.0; ++i) {
        crowding[front[i]] +=
            (points[front[i - 1]].*objective - points[front[i + 1]].*objective) / range;
    }
}

}  // namespace

// A point's front is one more than the last front that dominates it. Points are visited with
// falling first objective. A front then dominates the point if the largest second objective in it
// so far reaches the point's own. These largest values fall from front to front.
std::vector<std::size_t> pareto_fronts(std::span<const ParetoPoint> points) {
    const auto order = sorted_indices(points.size(), [&](std::size_t a, std::size_t b) {
        if (points[a].first != points[b].first) return points[a].first > points[b].first;
        return points[a].second > points[b].second;
    });
    std::vector<std::size_t> fronts(points.size(), 0);
    std::vector<ParetoPoint> tops;  // for each front, its point with the largest second objective
    for (const std::size_t i : order) {
        const ParetoPoint& point = points[i];
        const auto dominated_by = [&](const ParetoPoint& top) {
            if (top.second != point.second) return top.second > point.second;
            return top.first > point.first;
        };
        const auto free = std::partition_point(tops.begin(), tops.end(), dominated_by);
        fronts[i] = static_cast<std::size_t>(free - tops.begin());
        if (free == tops.end()) {
            tops.push_back(point);
        } else {
            *free = point;
        }
    }
    return fronts;
}

std::vector<std::size_t> pareto_order(std::span<const ParetoPoint> points) {
    const std::vector<std::size_t> fronts = pareto_fronts(points);
    std::vector<std::vector<std::size_t>> members;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (fronts[i] >= members.size()) members.resize(fronts[i] + 1);
        members[fronts[i]].push_back(i);
    }
    std::vector<double> crowding(points.size(), 0.0);
    for (const auto& front : members) {
        add_gaps(points, front, &ParetoPoint::first, crowding);
        add_gaps(points, front, &ParetoPoint::second, crowding);
    }
    return sorted_indices(points.size(), [&](std::size_t a, std::size_t b) {
        if (fronts[a] != fronts[b]) return fronts[a] < fronts[b];
        return crowding[a] > crowding[b];
    });
}

}  // namespace cambrian
