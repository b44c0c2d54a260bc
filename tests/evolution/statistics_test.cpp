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

TEST_CASE("fifteen generations without a rise of 1 percent are stagnation",
          "[evolution][statistics]") {
    std::vector<GenerationStatistics> history;
    const auto add = [&](double best) {
        GenerationStatistics next = summarize(test::individuals({best}), 0, 1);
        if (!history.empty()) continue_progress(next, history.back());
        history.push_back(next);
    };
    add(1.0);
    for (int i = 1; i <= 14; ++i)
        add(1.0 + 0.0006 * i);
    CHECK_FALSE(stagnant(history.back()));
    add(1.009);
    CHECK(stagnant(history.back()));
    add(1.0101);  // slow progress adds up
    CHECK_FALSE(stagnant(history.back()));
    CHECK(history.back().generations_without_progress == 0);
}

TEST_CASE("any rise from nothing is progress", "[evolution][statistics]") {
    const auto nothing = summarize(test::individuals({0.0}), 0, 1);
    auto something = summarize(test::individuals({1e-9}), 1, 1);
    continue_progress(something, nothing);
    CHECK(something.generations_without_progress == 0);
    auto still_nothing = summarize(test::individuals({0.0}), 1, 1);
    continue_progress(still_nothing, nothing);
    CHECK(still_nothing.generations_without_progress == 1);
}
