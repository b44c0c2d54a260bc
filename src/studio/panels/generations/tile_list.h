#pragma once

// The list of creatures that the population panel shows, and its order.

#include "evolution/engine/snapshot.h"
#include "studio/look/view_state.h"
#include "studio/viewer/stars.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

struct Tile {
    JudgedIndividual creature;
    // Rank by fitness in its generation, from 1; 0 if that generation is past.
    std::size_t rank = 0;
    bool starred = false;
    double key = 0.0;  // value by which the tiles are sorted, largest first
};

struct TileSorting {
    TileOrder order;
    const char* id;    // name in the stored view state
    const char* name;  // "Fitness"
    const char* what;  // description, one sentence
};
// Returns one entry for each TileOrder, in its order.
std::span<const TileSorting> tile_sortings();
const TileSorting& tile_sorting(TileOrder order);

// Selects the creatures to list.
struct TileFilter {
    bool starred_only = false;  // starred creatures of all generations
    bool one_a_plan = false;    // the best creature of each body plan

    friend bool operator==(const TileFilter&, const TileFilter&) = default;
};

// Returns the newest finished generation, or all starred creatures, sorted. Creatures with equal
// values stay in the order of their rank.
std::vector<Tile> list_tiles(const EvolutionSnapshot& snapshot, const Stars& stars, TileOrder order,
                             const TileFilter& filter);

}  // namespace cambrian
