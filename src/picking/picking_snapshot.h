#pragma once

// The state of picking as published after every change. It is immutable; copies are cheap.

#include "picking/grid/grid_settings.h"
#include "picking/picking_tree.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

enum class PickingStatus : std::uint8_t {
    kOpen,      // waits for a decision; children of the picks may be bred in advance
    kBreeding,  // a decision waits for its grid
    kEvolving,  // a decision waits for automatic evolution
};

struct PickingSnapshot {
    PickingTree tree;                // empty until the first grid is ready
    std::vector<std::size_t> picks;  // cells of the displayed grid, in order of picking
    GridSettings grid;               // options for the next grid
    SettingsPtr settings;            // settings that evaluate the next grid
    std::vector<JudgedIndividual> shelf;
    int decisions = 0;  // so far: breeding, immigrants, assistance
    int branches = 0;   // decisions where another one had been made before
    PickingStatus status = PickingStatus::kOpen;
    // The children of the picks are ready, so that BreedPicks is answered at once.
    bool children_ready = false;
    int generations_done = 0;  // generations of automatic evolution finished so far
    int generations_asked = 0;
    std::string message;  // why the last command was refused or failed; otherwise empty
};

// Returns the picked creatures in order of picking.
std::vector<IndividualPtr> picked_creatures(const PickingSnapshot& snapshot);

}  // namespace cambrian
