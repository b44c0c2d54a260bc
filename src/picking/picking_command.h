#pragma once

// What a person may ask for while picking. Plain values. One that makes no sense is refused: it
// changes nothing but the snapshot's message.

#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"
#include "picking/grid/grid_settings.h"
#include "picking/picking_snapshot.h"

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace cambrian {

// A grid of creatures of an automatic population, from then on under its settings; evaluated ones
// are shown at once.
struct ShowPopulation {
    SettingsPtr settings;  // must pass check_settings
    std::vector<IndividualPtr> population;
};
// A grid of given creatures' children, the first in cell 1; of random ones if none is given.
struct StartFromCreatures {
    std::vector<GenomePtr> genomes;  // at most kMostPicks
};
// The grids of another time, and where the person was among them.
struct RestoreGrids {
    PickingTree tree;                // empty: new tree
    std::vector<std::size_t> picks;  // cells of the grid shown
    std::vector<JudgedIndividual> shelf;
};
// Grids bred from now on are judged by other settings, which must pass check_settings.
struct UseSettings {
    SettingsPtr settings;
};
struct ChangeGrid {
    GridSettings grid;  // for the next one
};

// node: the grid that the person saw; a click on one no longer shown must not pick in another.
struct TogglePick {
    std::uint32_t node = 0;
    std::size_t cell = 0;
};
struct ClearPicks {};

// Decisions. The next grid is shown when it is ready; meanwhile the present one stays.
struct BreedPicks {};
struct ReplaceUnpicked {};  // by newcomers
struct AskEvolution {
    int generations = 10;  // 1 to kMostAssistedGenerations
};
struct CancelDecision {};  // while its grid is not ready

// Through the tree; what was picked there is picked again. While a decision is not ready, GoBack
// takes it back and stays; the others drop it.
struct GoBack {};
struct GoForward {};
struct VisitGrid {
    std::uint32_t node = 0;
};

// The shelf: creatures kept aside, to be put into any grid.
struct PinCreature {
    std::uint32_t node = 0;
    std::size_t cell = 0;
};
struct UnpinCreature {
    std::size_t place = 0;
};
struct PlacePinned {  // a new grid: this one with a pinned creature in the cell
    std::size_t place = 0;
    std::uint32_t node = 0;
    std::size_t cell = 0;
};

using PickingCommand =
    std::variant<ShowPopulation, StartFromCreatures, RestoreGrids, UseSettings, ChangeGrid,
                 TogglePick, ClearPicks, BreedPicks, ReplaceUnpicked, AskEvolution, CancelDecision,
                 GoBack, GoForward, VisitGrid, PinCreature, UnpinCreature, PlacePinned>;

}  // namespace cambrian
