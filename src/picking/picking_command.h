#pragma once

// The commands of selection by hand, as plain values. A command that cannot be carried out is
// refused: it changes only the snapshot's message.

#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"
#include "picking/grid/grid_settings.h"
#include "picking/picking_snapshot.h"

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace cambrian {

// Shows a grid chosen from an automatic population, whose settings apply from then on. Creatures
// that are already evaluated are shown at once.
struct ShowPopulation {
    SettingsPtr settings;  // must pass check_settings
    std::vector<IndividualPtr> population;
};
// Shows a grid with given creatures, the first in cell 1, and their children. Without given
// creatures it shows random ones.
struct StartFromCreatures {
    std::vector<GenomePtr> genomes;  // at most kMostPicks
};
// Restores the grids of a saved experiment and the user's place among them.
struct RestoreGrids {
    PickingTree tree;                // empty for a new tree
    std::vector<std::size_t> picks;  // cells of the displayed grid
    std::vector<JudgedIndividual> shelf;
};
// Evaluates future grids with other settings, which must pass check_settings().
struct UseSettings {
    SettingsPtr settings;
};
struct ChangeGrid {
    GridSettings grid;  // options for the next grid
};

// `node` is the grid that the user saw, so that a late click does not pick a creature of another
// grid.
struct TogglePick {
    std::uint32_t node = 0;
    std::size_t cell = 0;
};
struct ClearPicks {};

// The decisions. The next grid is shown when it is ready; until then the present one stays.
struct BreedPicks {};
struct ReplaceUnpicked {};  // replaces creatures that are not picked by random ones
struct AskEvolution {
    int generations = 10;  // 1 to kMostAssistedGenerations
};
struct CancelDecision {};  // cancels a decision whose grid is not ready

// Moves through the tree; the picks of the grid shown become the picks again. While a decision is
// not ready, GoBack only cancels it; the others cancel it and move.
struct GoBack {};
struct GoForward {};
struct VisitGrid {
    std::uint32_t node = 0;
};

// The shelf holds creatures that the user kept; they can be put into any grid.
struct PinCreature {
    std::uint32_t node = 0;
    std::size_t cell = 0;
};
struct UnpinCreature {
    std::size_t place = 0;
};
struct PlacePinned {  // makes a new grid: the displayed one with a pinned creature in the cell
    std::size_t place = 0;
    std::uint32_t node = 0;
    std::size_t cell = 0;
};

using PickingCommand =
    std::variant<ShowPopulation, StartFromCreatures, RestoreGrids, UseSettings, ChangeGrid,
                 TogglePick, ClearPicks, BreedPicks, ReplaceUnpicked, AskEvolution, CancelDecision,
                 GoBack, GoForward, VisitGrid, PinCreature, UnpinCreature, PlacePinned>;

}  // namespace cambrian
