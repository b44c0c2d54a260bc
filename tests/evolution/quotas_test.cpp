#include "evolution/selections/quotas.h"

#include "core/random.h"
#include "support/catch.h"

#include <numeric>

using namespace cambrian;

TEST_CASE("quotas of 40/30/30 are exact", "[evolution][quotas]") {
    const std::vector<double> shares = {0.4, 0.3, 0.3};
    using Counts = std::vector<std::size_t>;
    CHECK(largest_remainder(shares, 1) == Counts{1, 0, 0});
    CHECK(largest_remainder(shares, 7) == Counts{3, 2, 2});
    CHECK(largest_remainder(shares, 80) == Counts{32, 24, 24});
    CHECK(largest_remainder(shares, 240) == Counts{96, 72, 72});
}

TEST_CASE("quotas of random shares add up and are within one of exact", "[evolution][quotas]") {
    RandomStream stream(7);
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> shares(1 + stream.below(6));
        for (double& share : shares)
            share = stream.chance(0.2) ? 0.0 : stream.uniform();
        shares[0] += 1e-3;
        const std::size_t total = stream.below(500);
        const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
        const auto counts = largest_remainder(shares, total);
        REQUIRE(std::accumulate(counts.begin(), counts.end(), std::size_t{0}) == total);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            const double exact = shares[i] / sum * static_cast<double>(total);
            REQUIRE(std::abs(static_cast<double>(counts[i]) - exact) < 1.0);
        }
    }
}
