#pragma once

// Nearest neighbours among points, by Euclidean distance.

#include <array>
#include <compare>
#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

struct Neighbor {
    double distance = 0.0;
    std::size_t point = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14
    friend auto operator<=>(const Neighbor&, const Neighbor&) = default;
};

class NeighborSearch {
public:
    using Point = std::array<double, 3>;

    // The points must outlive the search.
    explicit NeighborSearch(std::span<const Point> points);

    // Returns the `count` nearest other points, the nearest first; of equally near ones those of
    // smaller index. `count` is less than the number of points. The result is valid until the next
    // call.
    std::span<const Neighbor> nearest(std::size_t point, std::size_t count);

private:
    // Equal points, as a range of order_.
    struct Group {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    const Point& of(const Group& group) const { return points_[order_[group.begin]]; }
    void consider(const Group& group, std::size_t point, std::size_t count);
    void insert(const Neighbor& candidate, std::size_t count);

    std::span<const Point> points_;
    std::vector<std::size_t> order_;     // points by their measures, equal ones by index
    std::vector<Group> groups_;          // in that order
    std::vector<std::size_t> group_of_;  // of each point
    std::vector<Neighbor> nearest_;
};

}  // namespace cambrian
