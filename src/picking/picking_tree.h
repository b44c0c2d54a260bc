#pragma once

// Every grid ever shown, as a tree: picking from a grid again makes a branch, and nothing is ever
// lost or overwritten. A value; copies share the grids.

#include "core/result.h"
#include "evolution/individual/judged_individual.h"
#include "evolution/settings/experiment_settings.h"
#include "picking/grid/grid_settings.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace cambrian {

// Where a grid came from.
enum class GridOrigin : std::uint8_t {
    kPopulation,  // chosen from an automatic population
    kCreatures,   // given creatures and their children
    kBreeding,    // children of the picks
    kNewcomers,   // random creatures in place of those not picked
    kAssistance,  // automatic evolution from the picks
    kShelf,       // a pinned creature put in a cell
};

struct GridNode {
    std::uint32_t number = 0;             // in order of making, from 0; the tree sets it
    std::optional<std::uint32_t> parent;  // the grid before; the tree sets it
    GridOrigin origin = GridOrigin::kBreeding;
    std::vector<std::size_t> picks;        // cells of the parent, in order of picking
    GridSettings grid;                     // asked for
    int generations = 0;                   // of automatic evolution
    SettingsPtr settings;                  // that judged the creatures
    std::vector<IndividualPtr> creatures;  // one a cell

    // The creature of a cell; its generation is the grid's number.
    JudgedIndividual cell(std::size_t cell) const { return {number, creatures[cell], settings}; }
};

class PickingTree {
public:
    bool empty() const { return nodes_.empty(); }
    std::size_t size() const { return nodes_.size(); }
    // Of a number below size().
    const GridNode& node(std::uint32_t number) const { return *nodes_[number]; }
    // The grid shown; only of a tree that is not empty.
    const GridNode& current() const { return *nodes_[current_]; }
    // In order of making.
    std::vector<std::uint32_t> children(std::uint32_t number) const;
    // The child that forward() leads to.
    std::optional<std::uint32_t> next() const;

    // Adds a grid after the current one and shows it.
    void add(GridNode node);
    // To the grid before, and to the one last come from or bred. False if there is none.
    bool back();
    bool forward();
    // To any grid; the way from the first one to it becomes the way forward.
    Status visit(std::uint32_t number);

private:
    void go_to(std::uint32_t number);

    std::vector<std::shared_ptr<const GridNode>> nodes_;  // by number
    std::vector<std::optional<std::uint32_t>> forward_;   // child of each that was shown last
    std::uint32_t current_ = 0;
};

}  // namespace cambrian
