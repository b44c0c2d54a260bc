#pragma once

// What there is to see of picking: immutable, shallow, published after every change.

#include "picking/grid/grid_settings.h"
#include "picking/picking_tree.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

enum class PickingStatus : std::uint8_t {
    kOpen,      // the person looks; children of the picks may be bred meanwhile
    kBreeding,  // a decision waits for its grid
    kEvolving,  // a decision waits for automatic evolution
};

struct PickingSnapshot {
    PickingTree tree;                // empty until the first grid is ready
    std::vector<std::size_t> picks;  // cells of the grid shown, in order of picking
    GridSettings grid;               // for the next one
    SettingsPtr settings;            // that judge the next one
    std::vector<JudgedIndividual> shelf;
    int decisions = 0;  // so far: breeding, newcomers, assistance
    int branches = 0;   // decisions where another one had been made before
    PickingStatus status = PickingStatus::kOpen;
    bool children_ready = false;  // of the picks: BreedPicks will be answered at once
    int generations_done = 0;     // while evolving
    int generations_asked = 0;
    std::string message;  // why the last command was refused or failed; else empty
};

// In order of picking.
std::vector<IndividualPtr> picked_creatures(const PickingSnapshot& snapshot);

}  // namespace cambrian
