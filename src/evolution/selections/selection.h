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

// Who survives, as far as several methods share it.
enum class SurvivalRule : std::uint8_t {
    kBestShare,   // truncated() of survival.h
    kElitesOnly,  // the elites; everybody may breed
    kOwn          // a rule of the method's own
};

// What a method adds its own settings to, and the conditions under which they make a difference.
struct SelectionRows {
    using Applies = std::function<bool(const ExperimentSettings&)>;

    setting_table::TableBuilder& table;
    Applies in_force;     // the settings select the method
    Applies elites_only;  // the settings select any method with SurvivalRule::kElitesOnly
};

struct SelectionKind {
    std::string id;
    std::string label;
    std::string help;
    // Its rule under these settings; null for kOwn.
    SurvivalRule (*survival)(const SelectionSettings& settings) = nullptr;
    bool fills_map = false;  // whether the fittest of every cell of the map survives
    // Adds its own settings; null if it has none.
    void (*add_settings)(SelectionRows& rows) = nullptr;
    // ranked: everyone evaluated, best first (by better()), not empty.
    SelectionResult (*select)(std::span<const IndividualPtr> ranked,
                              const ExperimentSettings& settings, SelectionMemory& memory,
                              RandomStream& stream) = nullptr;

    SurvivalRule survival_under(const SelectionSettings& settings) const {
        return survival == nullptr ? SurvivalRule::kOwn : survival(settings);
    }
};

using SelectionRegistry = Registry<SelectionKind>;

SelectionRegistry builtin_selections();

// Stochastic universal sampling: `count` picks, index i exactly floor or ceiling of its share of
// the weights (Baker 1987). Order shuffled. If no weight is positive, all count the same.
std::vector<std::size_t> universal_sampling(std::span<const double> weights, std::size_t count,
                                            RandomStream& stream);

}  // namespace cambrian
