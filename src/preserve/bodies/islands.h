#pragma once

// Joins bodies that may touch into islands, which are advanced as one (preserve/README.md 9).

#include "math/torus.h"
#include "world/physics_scene.h"

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace cambrian {

// Two bodies that may touch in this tick, the lower index first.
struct NearPair {
    double gap = 0.0;  // m, expected
    std::uint32_t first = 0, second = 0;
    Periods image = {};  // of the second one, which the first one may touch

    friend bool operator<(const NearPair& a, const NearPair& b) {
        return std::tie(a.gap, a.first, a.second, a.image) <
               std::tie(b.gap, b.first, b.second, b.image);
    }
};

class Islands {
public:
    // Begins with every body alone. An island is never larger than `most`.
    void begin(std::span<const SceneSize> sizes, const SceneSize& most);

    // Joins the islands of the pairs in ascending order of gaps, then of indices. Pairs whose
    // islands would be too large together become crowded, and so do those of an island that
    // reaches round the world.
    void join(std::vector<NearPair> pairs);

    bool are_joined(std::uint32_t a, std::uint32_t b) const { return find(a) == find(b); }
    // Returns whether two bodies of one island are together at that image.
    bool are_together(const NearPair& pair) const {
        return are_joined(pair.first, pair.second) &&
               image(pair.first) + pair.image == image(pair.second);
    }
    // Returns the representative of the body's island, its body of the lowest index.
    std::uint32_t find(std::uint32_t body) const;
    // Returns the image of the body that is in the island of its representative.
    Periods image(std::uint32_t body) const;
    const std::vector<NearPair>& crowded() const { return crowded_; }

private:
    std::vector<std::uint32_t> parents_;
    std::vector<Periods> images_;   // that are in the island of the parent
    std::vector<SceneSize> sizes_;  // of islands, at their representatives
    SceneSize most_;
    std::vector<NearPair> crowded_;
};

}  // namespace cambrian
