#include "evolution/statistics.h"

#include "support/catch.h"
#include "support/individuals.h"

using namespace cambrian;

TEST_CASE("statistics of 101 evenly spread creatures", "[evolution][statistics]") {
    std::vector<double> fitness;
    for (int i = 0; i <= 100; ++i)
        fitness.push_back(100.0 - i);
    const auto summary = summarize(test::individuals(fitness), 4, 77);
    CHECK(summary.generation == 4);
    CHECK(summary.size == 101);
    CHECK(summary.evaluations == 77);
    CHECK(summary.best == 100.0);
    CHECK(summary.upper == 90.0);
    CHECK(summary.median == 50.0);
    CHECK(summary.lower == 10.0);
    CHECK(summary.mean == Approx(50.0));
    CHECK(summary.distinct_genomes == 101);
}

TEST_CASE("only diverged and cheating creatures count as invalid", "[evolution][statistics]") {
    auto all = test::individuals({4, 3, 2, 1});
    const Outcome outcomes[] = {Outcome::kCompleted, Outcome::kRejected, Outcome::kDiverged,
                                Outcome::kCheated};
    for (std::size_t i = 0; i < all.size(); ++i) {
        Individual changed = *all[i];
        changed.result.outcome = outcomes[i];
        all[i] = std::make_shared<const Individual>(changed);
    }
    CHECK(summarize(all, 0, 4).invalid_share == Approx(0.5));
}
