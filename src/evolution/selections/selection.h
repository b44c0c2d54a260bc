#pragma once

// Selection of survivors and parents (evolution/README.md 1).

#include "core/random.h"
#include "core/registry.h"
#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"
#include "evolution/settings/setting_builder.h"

#include <cstddef>
#include <cstdint>
#include <functional>
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
    std::size_t immigrants = 0;              // number of random immigrants
    std::vector<double> partner_weights;     // one per individual of the ranking
};

// Rules of survival that several methods share.
enum class SurvivalRule : std::uint8_t {
    kBestShare,   // the creatures of truncated() in survival.h
    kElitesOnly,  // the elites; all creatures may breed
    kOwn          // a rule that only this method has
};

// The table to which a method adds its own settings, and conditions under which they have an
// effect.
struct SelectionRows {
    using Applies = std::function<bool(const ExperimentSettings&)>;

    setting_table::TableBuilder& table;
    Applies in_force;     // true while the method is selected
    Applies elites_only;  // true while a method with SurvivalRule::kElitesOnly is selected
};

struct SelectionKind {
    std::string id;
    std::string label;
    std::string help;
    // Returns its rule under these settings; null means kOwn.
    SurvivalRule (*survival)(const SelectionSettings& settings) = nullptr;
    bool fills_map = false;  // whether the fittest of every cell of the map survives
    // Adds its own settings; null means that it has none.
    void (*add_settings)(SelectionRows& rows) = nullptr;
    // `ranked` has all evaluated creatures, best first by better(); it is not empty.
    SelectionResult (*select)(std::span<const IndividualPtr> ranked,
                              const ExperimentSettings& settings, SelectionMemory& memory,
                              RandomStream& stream) = nullptr;

    SurvivalRule survival_under(const SelectionSettings& settings) const {
        return survival == nullptr ? SurvivalRule::kOwn : survival(settings);
    }
};

using SelectionRegistry = Registry<SelectionKind>;

SelectionRegistry builtin_selections();

// Stochastic universal sampling (Baker 1987). Returns `count` picks in random order; each index
// occurs as often as its share of the weights, rounded up or down. If no weight is positive, all
// are equal.
std::vector<std::size_t> universal_sampling(std::span<const double> weights, std::size_t count,
                                            RandomStream& stream);

}  // namespace cambrian
