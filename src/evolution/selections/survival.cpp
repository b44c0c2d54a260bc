#include "evolution/selections/survival.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cambrian {
namespace {

SelectionResult breed(std::size_t places, std::vector<std::size_t> survivors,
                      std::vector<double> weights, const ExperimentSettings& settings,
                      RandomStream& stream) {
    const Places shared = share_places(places, settings);
    SelectionResult result;
    result.survivors = std::move(survivors);
    result.first_parents = universal_sampling(weights, shared.offspring, stream);
    result.newcomers = shared.newcomers;
    result.partner_weights = std::move(weights);
    return result;
}

}  // namespace

std::vector<std::size_t> first_of_ranking(std::span<const IndividualPtr> ranked, std::size_t wanted,
                                          int max_clones) {
    std::vector<std::size_t> kept;
    std::map<std::uint64_t, int> copies;  // of those kept, by phenotype
    for (std::size_t i = 0; i < ranked.size() && kept.size() < wanted; ++i) {
        int& clones = copies[ranked[i]->result.phenotype];
        if (clones == max_clones) continue;
        kept.push_back(i);
        ++clones;
    }
    return kept;
}

std::vector<std::size_t> truncated(std::span<const IndividualPtr> ranked,
                                   const ExperimentSettings& settings) {
    const PopulationSettings& population = settings.population;
    const auto share = std::lround(population.survival * population.size);
    const auto wanted = std::clamp<std::int64_t>(share, 1, population.size);
    return first_of_ranking(ranked, static_cast<std::size_t>(wanted), population.max_clones);
}

std::span<const IndividualPtr> qualified(std::span<const IndividualPtr> ranked) {
    const auto end =
        std::find_if(ranked.begin(), ranked.end(),
                     [](const IndividualPtr& individual) { return disqualified(*individual); });
    const auto count = static_cast<std::size_t>(end - ranked.begin());
    return count == 0 ? ranked : ranked.first(count);
}

Places share_places(std::size_t places, const ExperimentSettings& settings) {
    const auto wanted = static_cast<std::size_t>(settings.population.immigrants);
    const std::size_t newcomers = std::min(places, wanted);
    return {places - newcomers, newcomers};
}

SelectionResult breed_by_weight(std::vector<std::size_t> survivors, std::vector<double> weights,
                                const ExperimentSettings& settings, RandomStream& stream) {
    const auto size = static_cast<std::size_t>(settings.population.size);
    const std::size_t places = size - std::min(size, survivors.size());
    return breed(places, std::move(survivors), std::move(weights), settings, stream);
}

SelectionResult breed_whole_batch(std::vector<std::size_t> survivors, std::vector<double> weights,
                                  const ExperimentSettings& settings, RandomStream& stream) {
    const auto size = static_cast<std::size_t>(settings.population.size);
    return breed(size, std::move(survivors), std::move(weights), settings, stream);
}

}  // namespace cambrian
