#include "evolution/individual/statistics.h"

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

TEST_CASE("lines and plans of survivors and births by line are counted",
          "[evolution][statistics]") {
    auto all = test::individuals({6, 5, 4, 3, 2, 1});
    const std::uint64_t lines[] = {7, 7, 8, 9, 9, 9};
    for (std::size_t i = 0; i < all.size(); ++i) {
        Individual one = *all[i];
        one.line = lines[i];
        one.result.plan = i / 2;
        one.born = i == 0 ? 2 : 3;
        all[i] = std::make_shared<const Individual>(one);
    }
    GenerationStatistics summary = summarize(all, 3, 6);
    count_lines(summary, all, std::vector<std::size_t>{0, 1, 2});
    CHECK(summary.lines == 2);
    CHECK(summary.plans == 2);
    CHECK(summary.births == std::vector<LineBirths>{{9, 3}, {7, 1}, {8, 1}});
}

TEST_CASE("the range of the best is that of its scores", "[evolution][statistics]") {
    auto all = test::individuals({3, 2});
    CHECK(summarize(all, 0, 2).best_lowest == 3.0);
    CHECK(summarize(all, 0, 2).best_highest == 3.0);
    Individual best = *all[0];
    best.result.scores = {3.0, 2.5, 4.0};
    all[0] = std::make_shared<const Individual>(best);
    CHECK(summarize(all, 0, 2).best_lowest == 2.5);
    CHECK(summarize(all, 0, 2).best_highest == 4.0);
}

TEST_CASE("only diverged and disqualified creatures count as invalid", "[evolution][statistics]") {
    auto all = test::individuals({4, 3, 2, 1});
    const Outcome outcomes[] = {Outcome::kCompleted, Outcome::kRejected, Outcome::kDiverged,
                                Outcome::kDisqualified};
    for (std::size_t i = 0; i < all.size(); ++i) {
        Individual changed = *all[i];
        changed.result.outcome = outcomes[i];
        all[i] = std::make_shared<const Individual>(changed);
    }
    CHECK(summarize(all, 0, 4).invalid_share == Approx(0.5));
}

TEST_CASE("scores are summarized of those that completed their trials", "[evolution][statistics]") {
    auto all = test::individuals({-0.1, -0.2, -0.3, 0.0, 0.0, 0.0, 0.0});
    for (std::size_t i = 3; i < all.size(); ++i) {
        Individual changed = *all[i];
        changed.result.outcome = i < 5 ? Outcome::kStoppedEarly : Outcome::kRejected;
        all[i] = std::make_shared<const Individual>(changed);
    }
    const GenerationStatistics summary = summarize(all, 0, 7);
    CHECK(summary.size == 7);
    CHECK(summary.best == -0.1);
    CHECK(summary.median == -0.2);
    CHECK(summary.lower == -0.3);
    CHECK(summary.mean == Approx(-0.2));
    const auto none = std::span(all).last(2);
    CHECK(summarize(none, 0, 2).mean == 0.0);
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
    add(1.0101);  // slow progress accumulates
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
