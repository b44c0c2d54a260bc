#pragma once

// From picks to candidates for the next grid (picking/README.md 1). Pure: the same picks, settings
// and number of the grid give the same candidates.

#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

// How many candidates of which kind are bred at a time.
struct BroodPlan {
    std::size_t copies = 0;  // of each parent, mutated
    std::size_t paired = 0;  // of two parents
    std::size_t newcomers = 0;

    friend bool operator==(const BroodPlan&, const BroodPlan&) = default;
};

// Three candidates a cell. One parent: all copies. Two or more (up to kMostPicks): two copies each,
// the rest paired. No parents: all newcomers; otherwise three for each of the newcomers' cells.
BroodPlan plan_brood(std::size_t parents, int cells, int newcomer_cells);

struct Brood {
    std::vector<IndividualPtr> offspring;
    std::vector<IndividualPtr> newcomers;
};

struct BroodOrder {
    std::span<const IndividualPtr> parents;
    int cells = 12;
    int newcomer_cells = 0;
    int extra_mutations = 0;
    std::uint32_t node = 0;  // number of the grid; the generation in which they are born
    int round = 0;           // of breeding for that grid
};

// Settings must pass check_settings. Copies are bred by the first method of one parent, pairs in
// equal numbers by the methods of two parents that have a default share.
Brood breed_candidates(const BroodOrder& order, const ExperimentSettings& settings,
                       const EvolutionKinds& kinds);

// The seed that replaces the experiment's in all of picking, so that grid n shares neither
// streams nor uids with automatic generation n.
std::uint64_t picking_seed(const ExperimentSettings& settings);

// Creatures from outside as parents of a grid. Genomes must be valid.
std::vector<IndividualPtr> import_creatures(std::span<const GenomePtr> genomes, std::uint32_t node,
                                            const ExperimentSettings& settings);

}  // namespace cambrian
