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
    result.immigrants = shared.immigrants;
    result.partner_weights = std::move(weights);
    return result;
}

constexpr double kShareWithLimits = 0.5;
constexpr std::size_t kNoLimit = static_cast<std::size_t>(-1);

struct Limits {
    std::size_t line = kNoLimit;  // largest number of creatures of one founder's line
    std::size_t plan = kNoLimit;  // largest number of creatures of one body plan
};

Limits limits_of(const SelectionSettings& settings, std::size_t wanted) {
    Limits limits;
    if (settings.line_share < 1.0) {
        const auto share = std::lround(settings.line_share * static_cast<double>(wanted));
        limits.line = static_cast<std::size_t>(std::max(1L, share));
    }
    if (settings.plan_copies > 0) limits.plan = static_cast<std::size_t>(settings.plan_copies);
    return limits;
}

// The survivors' places, which are given to one creature after another.
class Seats {
public:
    Seats(std::span<const IndividualPtr> ranked, std::size_t wanted, int max_clones)
        : ranked_(ranked), wanted_(wanted), max_clones_(max_clones), taken_(ranked.size(), false) {}

    // Gives places to the first `count` of the ranking, as far as limits and places allow.
    void seat(std::size_t count, const Limits& limits) {
        for (std::size_t i = 0; i < count && seated_ < wanted_; ++i) {
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
    void seat_one(std::size_t place, const Limits& limits) {
        const Individual& one = *ranked_[place];
        int& clones = clones_[one.result.phenotype];
        std::size_t& line = of_line_[one.line];
        std::size_t& plan = of_plan_[one.result.plan];
        if (clones == max_clones_ || line >= limits.line || plan >= limits.plan) return;
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

// Returns the number of creatures that finished a trial; they come first in the ranking.
std::size_t completed(std::span<const IndividualPtr> ranked) {
    const auto end = std::find_if(ranked.begin(), ranked.end(), [](const IndividualPtr& one) {
        return one->result.outcome != Outcome::kCompleted;
    });
    return static_cast<std::size_t>(end - ranked.begin());
}

}  // namespace

std::vector<std::size_t> first_of_ranking(std::span<const IndividualPtr> ranked, std::size_t wanted,
                                          int max_clones) {
    Seats seats(ranked, wanted, max_clones);
    seats.seat(ranked.size(), {});
    return seats.survivors();
}

std::size_t truncated_size(const PopulationSettings& population) {
    const auto share = std::lround(population.survival * population.size);
    return static_cast<std::size_t>(std::clamp<std::int64_t>(share, 1, population.size));
}

std::vector<std::size_t> truncated(std::span<const IndividualPtr> ranked,
                                   const ExperimentSettings& settings) {
    const std::size_t wanted = truncated_size(settings.population);
    const Limits limits = limits_of(settings.selection, wanted);
    Seats seats(ranked, wanted, settings.population.max_clones);
    const std::size_t finished = completed(ranked);
    seats.seat(finished, limits);
    seats.seat(finished, {.line = limits.line});
    seats.seat(ranked.size(), {});
    return seats.survivors();
}

SurvivalRule best_share(const SelectionSettings& /*settings*/) {
    return SurvivalRule::kBestShare;
}

double termination_share(const SelectionKind& kind, const SelectionSettings& settings) {
    if (kind.survival_under(settings) != SurvivalRule::kBestShare) return 0.0;
    const bool limited = settings.line_share < 1.0 || settings.plan_copies > 0;
    return limited ? kShareWithLimits : 1.0;
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
