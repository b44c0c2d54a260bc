#include "evolution/selections/nearest_neighbors.h"

#include "core/random.h"
#include "math/distance.h"
#include "support/catch.h"

#include <algorithm>
#include <cmath>

using namespace cambrian;

namespace {

// Finds the neighbours by their definition, among all others.
std::vector<Neighbor> sorted_others(const std::vector<NeighborSearch::Point>& points,
                                    std::size_t point) {
    std::vector<Neighbor> others;
    for (std::size_t other = 0; other < points.size(); ++other) {
        if (other != point) others.push_back({distance(points[point], points[other]), other});
    }
    std::sort(others.begin(), others.end());
    return others;
}

}  // namespace

TEST_CASE("the nearest neighbors are those that a search of all others finds", "[evolution]") {
    RandomStream stream(31);
    for (int round = 0; round < 60; ++round) {
        // Coarse measures make many points equal and many distances equal.
        const double grain = round % 3 == 0 ? 1.0 : 1e-9;
        std::vector<NeighborSearch::Point> points(2 + stream.below(80));
        for (NeighborSearch::Point& point : points) {
            for (double& measure : point)
                measure = grain * std::floor(stream.uniform(-3.0, 3.0) / grain);
        }
        NeighborSearch search(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t count = stream.below(points.size());
            const auto found = search.nearest(i, count);
            const auto expected = sorted_others(points, i);
            REQUIRE(found.size() == count);
            REQUIRE(std::equal(found.begin(), found.end(), expected.begin()));
        }
    }
}
