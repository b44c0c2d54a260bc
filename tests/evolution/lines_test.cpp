// Founder lines and body plans: membership, and limits on how many creatures of each survive.
#include "evolution/evaluation/evaluation.h"
#include "evolution/evolution.h"
#include "evolution/generation.h"
#include "evolution/selections/survival.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/fake_backend.h"
#include "support/individuals.h"

#include <map>

using namespace cambrian;
using test::kinds;
using test::ranking;

namespace {

ExperimentSettings half_of_ten() {
    ExperimentSettings settings;
    settings.population.size = 10;
    settings.population.survival = 0.5;
    settings.selection.line_share = 0.4;  // 2 of 5 survivors
    settings.selection.plan_copies = 0;
    return settings;
}

using Kept = std::vector<std::size_t>;

}  // namespace

TEST_CASE("of one founder's line no more survive than its share", "[evolution][lines]") {
    const auto ranked = ranking({1, 1, 1, 1, 2, 2, 2, 3, 3, 4}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    ExperimentSettings settings = half_of_ten();
    CHECK(truncated(ranked, settings) == Kept{0, 1, 4, 5, 7});
    settings.selection.line_share = 1.0;
    CHECK(truncated(ranked, settings) == Kept{0, 1, 2, 3, 4});
    settings.selection.line_share = 0.01;  // at least one survivor
    CHECK(truncated(ranked, settings) == Kept{0, 1, 4, 7, 9});
}

TEST_CASE("of one body plan no more survive than copies are allowed", "[evolution][lines]") {
    const auto ranked = ranking({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, {1, 1, 1, 2, 2, 2, 3, 3, 3, 4});
    ExperimentSettings settings = half_of_ten();
    settings.selection.plan_copies = 2;
    CHECK(truncated(ranked, settings) == Kept{0, 1, 3, 4, 6});
}

TEST_CASE("places that limits leave empty go to the best of the others", "[evolution][lines]") {
    ExperimentSettings settings = half_of_ten();
    settings.selection.plan_copies = 1;
    const auto alike = ranking({1, 1, 1, 1, 1, 2, 2, 2, 2, 2}, {1, 1, 1, 1, 1, 1, 1, 1, 1, 1});
    // The one plan first, then two of each line, then the best.
    CHECK(truncated(alike, settings) == Kept{0, 1, 2, 5, 6});
}

TEST_CASE("limits do not make failures survive", "[evolution][lines]") {
    auto ranked = ranking({1, 1, 1, 1, 1, 1, 2, 3, 4, 5}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    for (std::size_t i = 6; i < ranked.size(); ++i) {
        Individual failed = *ranked[i];
        failed.result.outcome = Outcome::kRejected;
        failed.result.fitness = 0.0;
        ranked[i] = std::make_shared<const Individual>(failed);
    }
    CHECK(truncated(ranked, half_of_ten()) == Kept{0, 1, 2, 3, 4});
}

TEST_CASE("limits hold among creatures whose trial was terminated early, which survive last",
          "[evolution][lines]") {
    auto ranked = ranking({1, 1, 1, 2, 2, 3, 3, 4, 4, 5}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    const auto terminate = [&](std::size_t place) {
        Individual terminated = *ranked[place];
        terminated.result.outcome = Outcome::kStoppedEarly;
        ranked[place] = std::make_shared<const Individual>(terminated);
    };
    for (std::size_t place = 6; place < ranked.size(); ++place)
        terminate(place);
    CHECK(truncated(ranked, half_of_ten()) == Kept{0, 1, 3, 4, 5});
    for (std::size_t place = 1; place < ranked.size(); ++place)
        terminate(place);
    CHECK(truncated(ranked, half_of_ten()) == Kept{0, 1, 2, 3, 4});
}

TEST_CASE("a child belongs to its mother's line, founders and random immigrants begin their own",
          "[evolution][lines]") {
    test::FakeBackend backend;
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = 30;
    settings->population.immigrants = 2;
    Evolution evolution(settings, kinds());
    EvaluationProgress progress;
    std::map<std::uint64_t, std::uint64_t> line_of;
    for (int generation = 0; generation < 5; ++generation) {
        for (const IndividualPtr& one : evolution.population()) {
            if (one->born == evolution.generation())
                CHECK(one->line == (one->parents[0] == 0 ? one->uid : line_of.at(one->parents[0])));
            line_of[one->uid] = one->line;
        }
        REQUIRE(evolution.evaluate(backend, progress, {}));
        evolution.breed();
    }
}

TEST_CASE("after fifty generations five lines and many plans survive", "[evolution][lines]") {
    test::FakeBackend backend;
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = 100;
    settings->selection.confirmations = 0;
    const auto diversity = [&] {
        Evolution evolution(settings, kinds());
        EvaluationProgress progress;
        for (int generation = 0; generation < 50; ++generation) {
            if (generation > 0) evolution.breed();
            REQUIRE(evolution.evaluate(backend, progress, {}));
        }
        const GenerationStatistics& last = evolution.history().back();
        int births = 0;
        for (const LineBirths& line : last.births)
            births += line.births;
        CHECK(births == 80);
        return last;
    };
    CHECK(diversity().lines >= 5);
    settings->selection.line_share = 1.0;
    settings->selection.plan_copies = 0;
    CHECK(diversity().lines < 5);
}
