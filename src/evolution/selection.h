#pragma once

// Who survives and who breeds how often (evolution.md 6).

#include "core/random.h"
#include "core/registry.h"
#include "evolution/experiment_settings.h"
#include "evolution/individual.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

struct SelectionResult {
    std::vector<std::size_t> survivors;      // indices into the ranking; pass unchanged
    std::vector<std::size_t> first_parents;  // one an offspring place, indices into the ranking
    std::vector<double> partner_weights;     // one an individual of the ranking
};

struct SelectionKind {
    std::string id;
    std::string label;
    std::string help;
    // ranked: everyone evaluated, best first (by better()). offspring is filled so that survivors
    // and offspring make a generation of settings.population.size, immigrants included in neither.
    SelectionResult (*select)(std::span<const IndividualPtr> ranked,
                              const ExperimentSettings& settings, RandomStream& stream) = nullptr;
};

using SelectionRegistry = Registry<SelectionKind>;

SelectionRegistry builtin_selections();

// Stochastic universal sampling: `count` picks, index i exactly floor or ceiling of its share of
// the weights (Baker 1987). Order shuffled.
std::vector<std::size_t> universal_sampling(std::span<const double> weights, std::size_t count,
                                            RandomStream& stream);

}  // namespace cambrian
