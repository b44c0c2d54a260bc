// Roulette over all creatures with sigma scaling (evolution/README.md 2). Creature i breeds in
// proportion to max(0, f_i - mean + 2 sd); only the elites survive.
#include "evolution/selections/survival.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

std::vector<double> sigma_scaled(std::span<const IndividualPtr> wheel, std::size_t size) {
    const double count = static_cast<double>(wheel.size());
    double mean = 0.0;
    for (const IndividualPtr& individual : wheel)
        mean += individual->result.fitness / count;
    double variance = 0.0;
    for (const IndividualPtr& individual : wheel) {
        const double off = individual->result.fitness - mean;
        variance += off * off / count;
    }
    std::vector<double> weights(size, 0.0);
    for (std::size_t i = 0; i < wheel.size(); ++i)
        weights[i] = std::fmax(0.0, wheel[i]->result.fitness - mean + 2.0 * std::sqrt(variance));
    // If all scores are equal, all creatures have the same weight.
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return !(w > 0.0); }))
        std::fill_n(weights.begin(), wheel.size(), 1.0);
    return weights;
}

SelectionResult select_by_roulette(std::span<const IndividualPtr> ranked,
                                   const ExperimentSettings& settings, SelectionMemory& /*memory*/,
                                   RandomStream& stream) {
    const int elites = std::min(settings.selection.elites, settings.population.size - 1);
    return breed_by_weight(
        first_of_ranking(ranked, static_cast<std::size_t>(elites), settings.population.max_clones),
        sigma_scaled(furthest(ranked), ranked.size()), settings, stream);
}

void add_roulette_settings(SelectionRows& rows) {
    rows.table
        .number(&SelectionSettings::elites, "elites", "Elites", "creatures", {1, 1000},
                "The number of best creatures that survive while all creatures may breed.")
        .applies = rows.elites_only;
}

}  // namespace

void add_roulette(SelectionRegistry& selections) {
    selections.add(
        {.id = "roulette",
         .label = "Roulette",
         .help = "All creatures may breed, fitter ones more often; only the elites survive.",
         .survival = [](const SelectionSettings&) { return SurvivalRule::kElitesOnly; },
         .add_settings = add_roulette_settings,
         .select = select_by_roulette});
}

}  // namespace cambrian
