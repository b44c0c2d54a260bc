#pragma once

// Finds the creatures whose bounds overlap: a grid of cells, in which each creature is entered
// wherever its bounds are.

#include "math/bounds.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace cambrian {

class Meetings {
public:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;  // indices, the lower one first

    // Returns all pairs whose bounds have a point in common, in ascending order. The result is
    // valid until the next call.
    std::span<const Pair> find(std::span<const Bounds> bounds);

private:
    struct Entry {
        std::int32_t row = 0, column = 0;
        std::uint32_t index = 0;
    };
    void enter(const Bounds& bounds, std::uint32_t index);

    std::vector<Entry> entries_;
    std::vector<Pair> pairs_;
};

}  // namespace cambrian
