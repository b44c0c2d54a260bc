#include "evolution/selections/selection.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

std::vector<std::size_t> universal_sampling(std::span<const double> weights, std::size_t count,
                                            RandomStream& stream) {
    CAMBRIAN_ASSERT(!weights.empty(), "a choice among none");
    double total = 0.0;
    for (const double weight : weights)
        total += weight;
    if (!(total > 0.0)) {
        return universal_sampling(std::vector<double>(weights.size(), 1.0), count, stream);
    }
    std::vector<std::size_t> picks;
    picks.reserve(count);
    const double start = stream.uniform();
    double reached = 0.0;  // sum of the weights so far, in units of one pick
    for (std::size_t i = 0; i < weights.size(); ++i) {
        reached += weights[i] / total * static_cast<double>(count);
        while (picks.size() < count && start + static_cast<double>(picks.size()) < reached) {
            picks.push_back(i);
        }
    }
    while (picks.size() < count)
        picks.push_back(weights.size() - 1);  // reached only if the last sum is rounded down
    stream.shuffle(std::span(picks));
    return picks;
}

}  // namespace cambrian
