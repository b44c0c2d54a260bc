// Tournament (evolution/README.md 2): each parent is the best of k creatures drawn uniformly from
// the survivors of truncation, or from all creatures, of which then only the elites survive. Of n
// contestants the i-th best (from 0) wins with probability ((n - i)^k - (n - i - 1)^k) / n^k.
#include "evolution/selections/survival.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cambrian {
namespace {

constexpr KindParameter<int> kSize{"tournament-size", 3};
constexpr KindParameter<bool> kOfAll{"tournament-of-all", false};

// Returns each contestant's probability of winning, the best one first.
std::vector<double> chances(std::size_t contestants, int size) {
    const auto all_below = [&](std::size_t place) {
        double chance = 1.0;
        for (int i = 0; i < size; ++i)
            chance *= static_cast<double>(contestants - place) / static_cast<double>(contestants);
        return chance;
    };
    std::vector<double> result;
    for (std::size_t place = 0; place < contestants; ++place)
        result.push_back(all_below(place) - all_below(place + 1));
    return result;
}

std::size_t winner(std::span<const std::size_t> contestants, int size, RandomStream& stream) {
    std::size_t best = contestants.size() - 1;
    for (int i = 0; i < size; ++i)
        best = std::min(best, stream.below(contestants.size()));
    return contestants[best];
}

SelectionResult select_by_tournament(std::span<const IndividualPtr> ranked,
                                     const ExperimentSettings& settings,
                                     SelectionMemory& /*memory*/, RandomStream& stream) {
    const SelectionSettings& chosen = settings.selection;
    const int max_clones = settings.population.max_clones;
    const auto size = static_cast<std::size_t>(settings.population.size);
    SelectionResult result;
    std::vector<std::size_t> contestants;
    if (kOfAll.of(chosen.own)) {
        const auto elites = std::min(static_cast<std::size_t>(chosen.elites), size - 1);
        result.survivors = first_of_ranking(ranked, elites, max_clones);
        contestants.resize(furthest(ranked).size());
        std::iota(contestants.begin(), contestants.end(), std::size_t{0});
    } else {
        result.survivors = truncated(ranked, settings);
        contestants = result.survivors;
    }
    const int contest = kSize.of(chosen.own);
    const std::vector<double> winning = chances(contestants.size(), contest);
    result.partner_weights.assign(ranked.size(), 0.0);
    for (std::size_t i = 0; i < contestants.size(); ++i)
        result.partner_weights[contestants[i]] = winning[i];
    const Places places = share_places(size - std::min(size, result.survivors.size()), settings);
    for (std::size_t i = 0; i < places.offspring; ++i)
        result.first_parents.push_back(winner(contestants, contest, stream));
    result.immigrants = places.immigrants;
    return result;
}

SurvivalRule survival_rule(const SelectionSettings& settings) {
    return kOfAll.of(settings.own) ? SurvivalRule::kElitesOnly : SurvivalRule::kBestShare;
}

void add_tournament_settings(SelectionRows& rows) {
    rows.table
        .number(
            kSize, kSize.key, "Tournament size", "creatures", {1, 100},
            "The number of contestants of a tournament. More contestants are a stronger selection.")
        .applies = rows.in_force;
    rows.table
        .flag(kOfAll, kOfAll.key, "Tournaments of all",
              "Contestants are drawn from the complete generation instead of its survivors.")
        .applies = rows.in_force;
}

}  // namespace

void add_tournament(SelectionRegistry& selections) {
    selections.add({.id = "tournament",
                    .label = "Tournament",
                    .help = "Each parent is the best of a few creatures drawn at random.",
                    .survival = survival_rule,
                    .add_settings = add_tournament_settings,
                    .select = select_by_tournament});
}

}  // namespace cambrian
