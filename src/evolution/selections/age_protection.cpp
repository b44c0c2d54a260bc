// Morphological age protection (after Cheney et al. 2018), evolution/README.md 2. A creature's age
// is the number of generations since its line of descent last changed its body. Parents, as many
// children and at least one random immigrant compete for the places by non-dominated sorting on
// (younger, fitter). A new body thus has time for its control to adapt to it.
#include "evolution/selections/pareto.h"
#include "evolution/selections/survival.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

std::vector<std::size_t> young_or_fit(std::span<const IndividualPtr> candidates,
                                      std::size_t wanted) {
    std::vector<ParetoPoint> points;
    for (const IndividualPtr& individual : candidates)
        points.push_back({static_cast<double>(individual->body_born), individual->result.fitness});
    std::vector<std::size_t> kept = pareto_order(points);
    kept.resize(std::min(kept.size(), wanted));
    std::sort(kept.begin(), kept.end());
    return kept;
}

SelectionResult select_by_age(std::span<const IndividualPtr> ranked,
                              const ExperimentSettings& settings, SelectionMemory& /*memory*/,
                              RandomStream& stream) {
    std::vector<std::size_t> survivors =
        young_or_fit(furthest(ranked), static_cast<std::size_t>(settings.population.size));
    std::vector<double> weights(ranked.size(), 0.0);
    for (const std::size_t survivor : survivors)
        weights[survivor] = 1.0;
    ExperimentSettings with_immigrant = settings;
    with_immigrant.population.immigrants = std::max(1, settings.population.immigrants);
    return breed_whole_batch(std::move(survivors), std::move(weights), with_immigrant, stream);
}

}  // namespace

void add_age_protection(SelectionRegistry& selections) {
    selections.add(
        {.id = "age-protection",
         .label = "Age protection",
         .help = "Young creatures compete with young ones, so new bodies have time to adapt.",
         .select = select_by_age});
}

}  // namespace cambrian
