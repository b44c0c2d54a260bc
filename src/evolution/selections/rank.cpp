// Truncation with offspring by rank (evolution/README.md 2). Of S survivors, the i-th best (from 0)
// breeds in proportion to S - i, however far apart their scores are.
#include "evolution/selections/survival.h"

#include <utility>

namespace cambrian {
namespace {

SelectionResult select_by_rank(std::span<const IndividualPtr> ranked,
                               const ExperimentSettings& settings, SelectionMemory& /*memory*/,
                               RandomStream& stream) {
    std::vector<std::size_t> survivors = truncated(ranked, settings);
    std::vector<double> weights(ranked.size(), 0.0);
    for (std::size_t place = 0; place < survivors.size(); ++place)
        weights[survivors[place]] = static_cast<double>(survivors.size() - place);
    return breed_by_weight(std::move(survivors), std::move(weights), settings, stream);
}

}  // namespace

void add_rank(SelectionRegistry& selections) {
    selections.add({.id = "rank",
                    .label = "Rank",
                    .help = "The best share survives and breeds by its rank alone.",
                    .survival = best_share,
                    .select = select_by_rank});
}

}  // namespace cambrian
