#pragma once

// Which creatures the population displays and in which order.

#include "evolution/engine/snapshot.h"
#include "studio/look/view_state.h"
#include "studio/viewer/stars.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

struct Tile {
    JudgedIndividual creature;
    std::size_t rank = 0;  // by merit in its generation, from 1; 0 if that has passed
    bool starred = false;
    double key = 0.0;  // what it was sorted by, greatest first
};

struct TileSorting {
    TileOrder order;
    const char* id;    // in the remembered view
    const char* name;  // "Fitness"
    const char* what;  // a sentence
};
// One an order, in that order.
std::span<const TileSorting> tile_sortings();
const TileSorting& tile_sorting(TileOrder order);

// Which of them to list.
struct TileFilter {
    bool starred_only = false;  // of all generations
    bool one_a_plan = false;    // the best of each body plan

    friend bool operator==(const TileFilter&, const TileFilter&) = default;
};

// The newest finished generation, or all that have a star, sorted; equals keep their rank's order.
std::vector<Tile> list_tiles(const EvolutionSnapshot& snapshot, const Stars& stars, TileOrder order,
                             const TileFilter& filter);

}  // namespace cambrian
