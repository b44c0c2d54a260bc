#pragma once

// Where the grids of a picking tree stand on its map: generations to the right, each branch on a
// row of its own.

#include "picking/picking_tree.h"

#include <vector>

namespace cambrian {

struct MapPlace {
    int column = 0;
    int row = 0;

    friend bool operator==(const MapPlace&, const MapPlace&) = default;
};

// One a grid, by number. The first grid bred from another goes on in its row.
std::vector<MapPlace> lay_out_map(const PickingTree& tree);

}  // namespace cambrian
