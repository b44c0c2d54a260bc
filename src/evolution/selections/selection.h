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

// What a selection carries from one generation to the next besides the survivors. It starts empty,
// and is emptied whenever scores are forgotten.
struct SelectionMemory {
    std::vector<IndividualPtr> archive;  // creatures once novel; they need not live any more
    double threshold = 0.0;              // novelty above which a creature joins the archive
    int quiet_generations = 0;           // since one last did
};

struct SelectionResult {
    std::vector<std::size_t> survivors;      // indices into the ranking; pass unchanged
    std::vector<std::size_t> first_parents;  // one an offspring place, indices into the ranking
    std::size_t newcomers = 0;               // places for new random creatures
    std::vector<double> partner_weights;     // one an individual of the ranking
};

struct SelectionKind {
    std::string id;
    std::string label;
    std::string help;
    // Share of the worst survivor's score that a creature must reach to survive; a trial that
    // cannot may end early. It is 1 if creatures below the worst survivor have no effect, less if
    // that is only likely, and 0 if the least fit may matter.
    double (*bar)(const SelectionSettings& settings) = nullptr;
    // ranked: everyone evaluated, best first (by better()), not empty.
    SelectionResult (*select)(std::span<const IndividualPtr> ranked,
                              const ExperimentSettings& settings, SelectionMemory& memory,
                              RandomStream& stream) = nullptr;
};

using SelectionRegistry = Registry<SelectionKind>;

SelectionRegistry builtin_selections();

// Stochastic universal sampling: `count` picks, index i exactly floor or ceiling of its share of
// the weights (Baker 1987). Order shuffled. If no weight is positive, all count the same.
std::vector<std::size_t> universal_sampling(std::span<const double> weights, std::size_t count,
                                            RandomStream& stream);

}  // namespace cambrian
