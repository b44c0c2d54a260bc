#include "evolution/selections/quotas.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cambrian {

std::vector<std::size_t> largest_remainder(std::span<const double> shares, std::size_t total) {
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    CAMBRIAN_ASSERT(sum > 0.0, "shares with a positive sum");
    std::vector<std::size_t> counts(shares.size());
    std::vector<double> remainders(shares.size());
    std::size_t given = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double exact = shares[i] / sum * static_cast<double>(total);
        counts[i] = static_cast<std::size_t>(exact);
        remainders[i] = exact - std::floor(exact);
        given += counts[i];
    }
    std::vector<std::size_t> order(shares.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return remainders[a] > remainders[b]; });
    for (std::size_t i = 0; given < total; ++i, ++given)
        ++counts[order[i % order.size()]];
    return counts;
}

}  // namespace cambrian
