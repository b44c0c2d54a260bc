// Truncation with proportional offspring, evolution.md 6.1: the best share survives unchanged,
// which is the elitism, and survivor i breeds in proportion to
//
//     w_i = 0.2 + (f_i - f_S) / (f_1 - f_S)
//
// with f_1 the best and f_S the worst survivor's fitness (all 1 if they are equal), numbers
// assigned by stochastic universal sampling. Only differences count, so fitness may be zero or
// negative.
#include "evolution/selection.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kWorstWeight = 0.2;

std::size_t clones_among(std::span<const IndividualPtr> ranked,
                         std::span<const std::size_t> survivors, const Individual& candidate) {
    std::size_t count = 0;
    for (const std::size_t index : survivors) {
        const Individual& other = *ranked[index];
        if (other.genome_hash == candidate.genome_hash && *other.genome == *candidate.genome) {
            ++count;
        }
    }
    return count;
}

std::vector<std::size_t> pick_survivors(std::span<const IndividualPtr> ranked, std::size_t wanted,
                                        std::size_t max_clones) {
    std::vector<std::size_t> survivors;
    for (std::size_t i = 0; i < ranked.size() && survivors.size() < wanted; ++i) {
        if (clones_among(ranked, survivors, *ranked[i]) < max_clones) survivors.push_back(i);
    }
    return survivors;
}

std::vector<double> breeding_weights(std::span<const IndividualPtr> ranked,
                                     std::span<const std::size_t> survivors) {
    const double best = ranked[survivors.front()]->result.fitness;
    const double worst = ranked[survivors.back()]->result.fitness;
    std::vector<double> weights(ranked.size(), 0.0);
    for (const std::size_t index : survivors) {
        weights[index] =
            best > worst ? kWorstWeight + (ranked[index]->result.fitness - worst) / (best - worst)
                         : 1.0;
    }
    return weights;
}

SelectionResult select_by_truncation(std::span<const IndividualPtr> ranked,
                                     const ExperimentSettings& settings, RandomStream& stream) {
    const PopulationSettings& population = settings.population;
    const auto size = static_cast<std::size_t>(population.size);
    const auto share = static_cast<std::size_t>(std::lround(population.survival * population.size));
    SelectionResult result;
    result.survivors = pick_survivors(ranked, std::clamp<std::size_t>(share, 1, size),
                                      static_cast<std::size_t>(population.max_clones));
    result.partner_weights = breeding_weights(ranked, result.survivors);
    const std::size_t free = size - result.survivors.size();
    const std::size_t immigrants = std::min(free, static_cast<std::size_t>(population.immigrants));
    result.first_parents = universal_sampling(result.partner_weights, free - immigrants, stream);
    return result;
}

}  // namespace

void register_truncation(SelectionRegistry& selections) {
    selections.add({.id = "truncation",
                    .label = "Truncation",
                    .help = "The best share survives and breeds in proportion to its success.",
                    .select = select_by_truncation});
}

}  // namespace cambrian
