#pragma once

// Finds the creatures whose bounds overlap: a grid of cells, in which each creature is entered
// wherever its bounds are.

#include "math/bounds.h"
#include "math/torus.h"

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace cambrian {

class BroadPhase {
public:
    struct Pair {
        std::uint32_t first = 0, second = 0;  // indices, the lower one first
        Periods image = {};                   // of the second one, which the first one meets

        friend bool operator==(const Pair&, const Pair&) = default;
        friend bool operator<(const Pair& a, const Pair& b) {
            return std::tie(a.first, a.second, a.image) < std::tie(b.first, b.second, b.image);
        }
    };

    explicit BroadPhase(const Torus& torus = {}) : torus_(torus) {}

    // Returns all pairs whose bounds, or images of them, have a point in common, in ascending
    // order; a pair is listed for each image. Nobody meets itself. The result is valid until the
    // next call.
    std::span<const Pair> find(std::span<const Bounds> bounds);

private:
    // An image of a creature that reaches into the area around 0 0. That with no laps is in the
    // area with its lower left corner.
    struct Copy {
        Bounds bounds;
        Periods laps, image;
        std::uint32_t index = 0;
    };
    struct Entry {
        std::int32_t row = 0, column = 0;
        std::uint32_t copy = 0;
    };
    void add_copies(const Bounds& bounds, std::uint32_t index);
    void enter(std::uint32_t copy);
    void add_pair(const Copy& a, const Copy& b, const Entry& cell);

    Torus torus_;
    std::vector<Copy> copies_;
    std::vector<Entry> entries_;
    std::vector<Pair> pairs_;
};

}  // namespace cambrian
