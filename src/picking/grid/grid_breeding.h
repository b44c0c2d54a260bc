#pragma once

// Breeds candidates for the next grid from the picks (picking/README.md 1). The result depends only
// on the picks, the settings and the grid's number.

#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

// The number of candidates for each breeding method in one round.
struct CandidatePlan {
    std::size_t copies = 0;  // mutated copies per parent
    std::size_t paired = 0;  // children of two parents
    std::size_t immigrants = 0;

    friend bool operator==(const CandidatePlan&, const CandidatePlan&) = default;
};

// Plans three candidates per cell. One parent has only copies. Two or more parents (up to
// kMostPicks) have two copies each; all other children have two parents. Without parents all
// candidates are random creatures, otherwise three per cell reserved for them.
CandidatePlan plan_candidates(std::size_t parents, int cells, int immigrant_cells);

struct Candidates {
    std::vector<IndividualPtr> offspring;
    std::vector<IndividualPtr> immigrants;
};

struct CandidateOrder {
    std::span<const IndividualPtr> parents;
    int cells = 12;
    int immigrant_cells = 0;
    int extra_mutations = 0;
    std::uint32_t node = 0;  // number of the grid, which is its creatures' generation of birth
    int round = 0;           // round of breeding for that grid, from 0
};

// The settings must pass check_settings(). Copies are bred by the first method of one parent, the
// others in equal numbers by the methods of two parents that have a default share.
Candidates breed_candidates(const CandidateOrder& order, const ExperimentSettings& settings,
                            const EvolutionKinds& kinds);

// Returns the seed that picking uses instead of the experiment's. Grid n thus shares neither random
// streams nor uids with generation n of automatic evolution.
std::uint64_t picking_seed(const ExperimentSettings& settings);

// Makes individuals of genomes from outside, to be parents of a grid. The genomes must be valid.
std::vector<IndividualPtr> import_creatures(std::span<const GenomePtr> genomes, std::uint32_t node,
                                            const ExperimentSettings& settings);

}  // namespace cambrian
