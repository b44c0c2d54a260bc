#pragma once

// Selection of survivors and parents (evolution/README.md 1).

#include "core/random.h"
#include "core/registry.h"
#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

// The state that a selection carries from one generation to the next besides the survivors. It is
// empty at first, and emptied whenever scores are discarded.
struct SelectionMemory {
    // Creatures that were novel once; they need not live any more.
    std::vector<IndividualPtr> archive;
    double threshold = 0.0;     // novelty above which a creature enters the archive
    int quiet_generations = 0;  // generations since the last one entered
};

struct SelectionResult {
    std::vector<std::size_t> survivors;      // indices into the ranking; they remain unchanged
    std::vector<std::size_t> first_parents;  // one per offspring, indices into the ranking
    std::size_t newcomers = 0;               // number of random immigrants
    std::vector<double> partner_weights;     // one per individual of the ranking
};

struct SelectionKind {
    std::string id;
    std::string label;
    std::string help;
    // Returns the share of the worst survivor's score that a creature must reach to survive. A
    // trial that cannot reach it may end early. The share is 1 if creatures below the worst
    // survivor have no effect, less if that is only likely, and 0 if the least fit may matter.
    double (*bar)(const SelectionSettings& settings) = nullptr;
    // `ranked` has all evaluated creatures, best first by better(); it is not empty.
    SelectionResult (*select)(std::span<const IndividualPtr> ranked,
                              const ExperimentSettings& settings, SelectionMemory& memory,
                              RandomStream& stream) = nullptr;
};

using SelectionRegistry = Registry<SelectionKind>;

SelectionRegistry builtin_selections();

// Stochastic universal sampling (Baker 1987). Returns `count` picks in random order; each index
// occurs as often as its share of the weights, rounded up or down. If no weight is positive, all
// are equal.
std::vector<std::size_t> universal_sampling(std::span<const double> weights, std::size_t count,
                                            RandomStream& stream);

}  // namespace cambrian
