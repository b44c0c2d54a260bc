#pragma once

// The layout of the picking tree's map. Generations run to the right, and each branch has its own
// row.

#include "picking/picking_tree.h"

#include <vector>

namespace cambrian {

struct MapPlace {
    int column = 0;
    int row = 0;

    friend bool operator==(const MapPlace&, const MapPlace&) = default;
};

// Returns one place per grid, indexed by its number. The first grid bred from a grid stays in its
// row.
std::vector<MapPlace> lay_out_map(const PickingTree& tree);

}  // namespace cambrian
