#pragma once

// What panels see of selection by hand.

#include "picking/picking_snapshot.h"
#include "studio/hand_picking/grid_motion.h"

#include <cstddef>
#include <string>

namespace cambrian {

// What is shown besides the creatures, and how much help is asked for.
struct PickingOptions {
    bool scores = false;
    bool hints = false;  // who is fastest, highest, oddest
    int assisted_generations = 10;

    friend bool operator==(const PickingOptions&, const PickingOptions&) = default;
};

struct PickingView {
    const PickingSnapshot& snapshot;
    const GridMotion& motion;
    const PickingOptions& options;
    std::size_t focus = 0;  // the cell that keys act on
    bool single = false;    // one creature has the viewport, not the grid
    bool playing = true;
    float progress = 0.0F;  // share of the grid being made
};

inline bool deciding(const PickingSnapshot& snapshot) {
    return snapshot.status != PickingStatus::kOpen;
}
// Columns of a grid of so many cells: "12" is 4 by 3.
int grid_columns(int cells);
// Place of a cell among the picks, from 1; 0 if it is not picked.
int pick_number(const PickingSnapshot& snapshot, std::size_t cell);

// How far picking is and what to do next, in one short line.
std::string picking_words(const PickingSnapshot& snapshot);
// "bred from 3 picks", "chosen from the population".
std::string origin_words(const GridNode& node);
// How a creature came to be: its method and what changed, a line each.
std::string change_words(const Individual& creature);

}  // namespace cambrian
