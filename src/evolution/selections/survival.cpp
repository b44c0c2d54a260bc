#include "evolution/selections/survival.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace cambrian {
namespace {

SelectionResult breed(std::size_t places, std::vector<std::size_t> survivors,
                      std::vector<double> weights, const ExperimentSettings& settings,
                      RandomStream& stream) {
    const Places shared = share_places(places, settings);
    SelectionResult result;
    result.survivors = std::move(survivors);
    result.first_parents = universal_sampling(weights, shared.offspring, stream);
    result.immigrants = shared.immigrants;
    result.partner_weights = std::move(weights);
    return result;
}

// The survivors' places, which are given to one creature after another.
class Seats {
public:
    Seats(std::span<const IndividualPtr> ranked, std::size_t wanted, int max_clones)
        : ranked_(ranked), wanted_(wanted), max_clones_(max_clones), taken_(ranked.size(), false) {}

    // Gives places to these of the ranking, in their order, as far as limits and places allow.
    void seat(std::span<const std::size_t> candidates, const SurvivalLimits& limits) {
        for (const std::size_t i : candidates) {
            if (seated_ == wanted_) return;
            if (!taken_[i]) seat_one(i, limits);
        }
    }
    // Returns the survivors in the order of the ranking.
    std::vector<std::size_t> survivors() const {
        std::vector<std::size_t> kept;
        for (std::size_t i = 0; i < taken_.size(); ++i) {
            if (taken_[i]) kept.push_back(i);
        }
        return kept;
    }

private:
    static bool reaches(std::size_t count, std::optional<std::size_t> limit) {
        return limit && count >= *limit;
    }
    void seat_one(std::size_t place, const SurvivalLimits& limits) {
        const Individual& one = *ranked_[place];
        int& clones = clones_[one.result.phenotype];
        std::size_t& line = of_line_[one.line];
        std::size_t& plan = of_plan_[one.result.plan];
        if (clones == max_clones_ || reaches(line, limits.line) || reaches(plan, limits.plan))
            return;
        ++clones;
        ++line;
        ++plan;
        ++seated_;
        taken_[place] = true;
    }

    std::span<const IndividualPtr> ranked_;
    std::size_t wanted_;
    int max_clones_;
    std::vector<bool> taken_;
    std::size_t seated_ = 0;
    std::map<std::uint64_t, int> clones_;
    std::map<std::uint64_t, std::size_t> of_line_;
    std::map<std::uint64_t, std::size_t> of_plan_;
};

}  // namespace

std::vector<std::size_t> everybody(std::span<const IndividualPtr> ranked) {
    std::vector<std::size_t> places(ranked.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    return places;
}

std::vector<std::size_t> first_of_ranking(std::span<const IndividualPtr> ranked, std::size_t wanted,
                                          int max_clones) {
    Seats seats(ranked, wanted, max_clones);
    seats.seat(everybody(ranked), {});
    return seats.survivors();
}

std::vector<double> leads(std::span<const IndividualPtr> ranked,
                          std::span<const std::size_t> places) {
    const EvaluationResult& best = ranked[places.front()]->result;
    const auto came_as_far = [&](std::size_t place) {
        return shortfall(ranked[place]->result.outcome) == shortfall(best.outcome);
    };
    double worst = best.fitness;
    for (const std::size_t place : places) {
        if (came_as_far(place)) worst = std::min(worst, ranked[place]->result.fitness);
    }
    const double range = best.fitness - worst;
    std::vector<double> result;
    result.reserve(places.size());
    for (const std::size_t place : places) {
        const double lead = ranked[place]->result.fitness - worst;
        const double share = range > 0.0 ? lead / range : 1.0;
        result.push_back(came_as_far(place) ? share : 0.0);
    }
    return result;
}

std::size_t truncated_size(const PopulationSettings& population) {
    const auto share = std::lround(population.survival * population.size);
    return static_cast<std::size_t>(std::clamp<std::int64_t>(share, 1, population.size));
}

std::vector<std::size_t> truncated(std::span<const IndividualPtr> ranked,
                                   const ExperimentSettings& settings) {
    const std::size_t wanted = truncated_size(settings.population);
    const SurvivalLimits limits = survival_limits(settings);
    Seats seats(ranked, wanted, settings.population.max_clones);
    const std::vector<std::size_t> candidates = everybody(furthest(ranked));
    seats.seat(candidates, limits);
    seats.seat(candidates, {.line = limits.line});
    seats.seat(candidates, {});
    seats.seat(everybody(ranked), {});
    return seats.survivors();
}

SurvivalRule best_share(const SelectionSettings& /*settings*/) {
    return SurvivalRule::kBestShare;
}

SurvivalLimits survival_limits(const ExperimentSettings& settings) {
    const SelectionSettings& selection = settings.selection;
    SurvivalLimits limits;
    if (selection.line_share < 1.0) {
        const auto wanted = static_cast<double>(truncated_size(settings.population));
        const auto share = std::lround(selection.line_share * wanted);
        limits.line = static_cast<std::size_t>(std::max(1L, share));
    }
    if (selection.plan_copies > 0) limits.plan = static_cast<std::size_t>(selection.plan_copies);
    return limits;
}

bool may_terminate_early(const SelectionKind& kind, const ExperimentSettings& settings) {
    return kind.survival_under(settings.selection) == SurvivalRule::kBestShare &&
           settings.world.trial.trials == 1;
}

Places share_places(std::size_t places, const ExperimentSettings& settings) {
    const auto wanted = static_cast<std::size_t>(settings.population.immigrants);
    const std::size_t immigrants = std::min(places, wanted);
    return {places - immigrants, immigrants};
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
