#pragma once

// All grids shown so far, as a tree. Picking again from an earlier grid makes a branch; no grid is
// ever lost or overwritten. The tree has value semantics; copies share the grids.

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

// The way in which a grid was made.
enum class GridOrigin : std::uint8_t {
    kPopulation,  // chosen from an automatic population
    kCreatures,   // given creatures and their children
    kBreeding,    // children of the picks
    kImmigrants,  // random creatures in place of those not picked
    kAssistance,  // automatic evolution from the picks
    kShelf,       // a pinned creature was put into a cell
};

struct GridNode {
    std::uint32_t number = 0;             // index in order of creation, from 0; set by the tree
    std::optional<std::uint32_t> parent;  // the grid it was made from; set by the tree
    GridOrigin origin = GridOrigin::kBreeding;
    std::vector<std::size_t> picks;        // cells of the parent, in order of picking
    GridSettings grid;                     // options it was made with
    int generations = 0;                   // generations of automatic evolution before it
    SettingsPtr settings;                  // settings that evaluated the creatures
    std::vector<IndividualPtr> creatures;  // one per cell

    // Returns the creature of a cell; its generation is the grid's number.
    JudgedIndividual cell(std::size_t cell) const { return {number, creatures[cell], settings}; }
};

class PickingTree {
public:
    bool empty() const { return nodes_.empty(); }
    std::size_t size() const { return nodes_.size(); }
    // The number must be less than size().
    const GridNode& node(std::uint32_t number) const { return *nodes_[number]; }
    // Returns the displayed grid; the tree must not be empty.
    const GridNode& current() const { return *nodes_[current_]; }
    // Returns the child to which forward() moves.
    std::optional<std::uint32_t> next() const;

    // Adds a grid as a child of the present one and moves to it.
    void add(GridNode node);
    // Move to the parent, or to the child that was visited or bred last. They return false if there
    // is none.
    bool back();
    bool forward();
    // Moves to any grid. forward() then follows the path from the first grid to it.
    Status visit(std::uint32_t number);

private:
    void go_to(std::uint32_t number);

    std::vector<std::shared_ptr<const GridNode>> nodes_;  // by number
    // The child of each grid that was visited last.
    std::vector<std::optional<std::uint32_t>> forward_;
    std::uint32_t current_ = 0;
};

}  // namespace cambrian
