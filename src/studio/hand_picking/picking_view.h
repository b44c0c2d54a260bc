#pragma once

// The data of selection by hand that panels see.

#include "evolution/kinds/evolution_kinds.h"
#include "picking/picking_snapshot.h"
#include "studio/hand_picking/grid_motion.h"

#include <cstddef>
#include <string>

namespace cambrian {

// All that is shown besides the creatures, and the help that automatic evolution gives.
struct PickingOptions {
    bool scores = false;
    bool hints = false;  // marks the fastest, the highest and the most unusual creature
    int assisted_generations = 10;

    friend bool operator==(const PickingOptions&, const PickingOptions&) = default;
};

struct PickingView {
    const PickingSnapshot& snapshot;
    const GridMotion& motion;
    const PickingOptions& options;
    std::size_t focus = 0;  // index of the cell that keys act on
    bool single = false;    // the viewport displays one creature instead of the grid
    bool playing = true;
    float progress = 0.0F;  // share of the next grid that is finished, in [0, 1]
};

inline bool deciding(const PickingSnapshot& snapshot) {
    return snapshot.status != PickingStatus::kOpen;
}
// Returns the number of columns of a grid of so many cells; 12 cells are 4 by 3.
int grid_columns(int cells);
// Returns the rank of a cell among the picks, from 1, or 0 if it is not picked.
int pick_number(const PickingSnapshot& snapshot, std::size_t cell);

// Returns one short line on how far picking is and what to do next.
std::string picking_words(const PickingSnapshot& snapshot);
// Returns how a grid was made: "bred from 3 picks", "chosen from the population".
std::string origin_words(const GridNode& node);
// Returns how a creature was bred: the method and its mutations, one per line.
std::string change_words(const Individual& creature, const EvolutionKinds& kinds);

}  // namespace cambrian
