#include "evolution/selections/pareto.h"

#include "core/random.h"
#include "support/catch.h"

#include <algorithm>

using namespace cambrian;

namespace {

bool dominates(const ParetoPoint& a, const ParetoPoint& b) {
    return a.first >= b.first && a.second >= b.second && (a.first > b.first || a.second > b.second);
}

// Computes the fronts by their definition, one after the other.
std::vector<std::size_t> peeled_fronts(const std::vector<ParetoPoint>& points) {
    std::vector<std::size_t> fronts(points.size(), points.size());
    for (std::size_t front = 0; front < points.size(); ++front) {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (fronts[i] < front) continue;
            bool dominated = false;
            for (std::size_t j = 0; j < points.size(); ++j)
                dominated = dominated || (fronts[j] >= front && dominates(points[j], points[i]));
            if (!dominated) members.push_back(i);
        }
        for (const std::size_t i : members)
            fronts[i] = front;
    }
    return fronts;
}

}  // namespace

TEST_CASE("fronts are those of the definition, ties included", "[evolution][pareto]") {
    RandomStream stream(5);
    for (int round = 0; round < 300; ++round) {
        std::vector<ParetoPoint> points(1 + stream.below(40));
        for (ParetoPoint& point : points)
            point = {static_cast<double>(stream.below(8)), static_cast<double>(stream.below(8))};
        CHECK(pareto_fronts(points) == peeled_fronts(points));
    }
}

TEST_CASE("the extremes of a front come first, then those with room around them",
          "[evolution][pareto]") {
    const std::vector<ParetoPoint> points = {{5, 5}, {0, 10}, {5.5, 4.9}, {10, 0}, {9, 3}, {1, 1}};
    const auto order = pareto_order(points);
    CHECK(std::min(order[0], order[1]) == 1);
    CHECK(std::max(order[0], order[1]) == 3);
    CHECK(order.back() == 5);
    CHECK(order[order.size() - 2] == 2);  // the most crowded point of the first front
}
