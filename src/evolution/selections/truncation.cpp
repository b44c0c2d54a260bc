// Truncation with proportional offspring (evolution/README.md 1). The best share survives
// unchanged, which is the elitism. Survivor i breeds in proportion to
//
//     w_i = 0.2 + (f_i - f_S) / (f_1 - f_S)
//
// where f_1 is the best and f_S the least fitness of the survivors that completed their trials (the
// quotient is 1 if these are equal). Survivors that did not complete theirs have 0.2.
// Numbers are assigned by stochastic universal sampling. Only differences matter, so fitness may be
// zero or negative.
#include "evolution/selections/survival.h"

#include <utility>

namespace cambrian {
namespace {

constexpr double kWorstWeight = 0.2;

std::vector<double> breeding_weights(std::span<const IndividualPtr> ranked,
                                     std::span<const std::size_t> survivors) {
    const std::vector<double> lead = leads(ranked, survivors);
    std::vector<double> weights(ranked.size(), 0.0);
    for (std::size_t i = 0; i < survivors.size(); ++i)
        weights[survivors[i]] = kWorstWeight + lead[i];
    return weights;
}

SelectionResult select_by_truncation(std::span<const IndividualPtr> ranked,
                                     const ExperimentSettings& settings,
                                     SelectionMemory& /*memory*/, RandomStream& stream) {
    std::vector<std::size_t> survivors = truncated(ranked, settings);
    std::vector<double> weights = breeding_weights(ranked, survivors);
    return breed_by_weight(std::move(survivors), std::move(weights), settings, stream);
}

}  // namespace

void add_truncation(SelectionRegistry& selections) {
    selections.add({.id = "truncation",
                    .label = "Truncation",
                    .help = "The best share survives, and its fitter creatures breed more often.",
                    .survival = best_share,
                    .select = select_by_truncation});
}

}  // namespace cambrian
