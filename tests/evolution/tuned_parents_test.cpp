// The tests of evolution/README.md 6.
#include "evolution/tuned_parents.h"

#include "evolution/evolution.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/fake_backend.h"
#include "support/individuals.h"

#include <map>

using namespace cambrian;
using test::kinds;
using test::ranking;

namespace {

// Returns how often each creature is the parent of a tuned child.
std::map<std::size_t, int> counts(const std::vector<IndividualPtr>& ranked,
                                  const std::vector<std::size_t>& survivors, double share) {
    RandomStream stream(7);
    std::map<std::size_t, int> times;
    for (const auto& parent : draw_tuned_parents(ranked, survivors, 20'000, share, stream)) {
        if (parent) ++times[*parent];
    }
    return times;
}

}  // namespace

TEST_CASE("the best of every line is tuned, fitter ones more often", "[evolution][tuning]") {
    const auto times = counts(ranking({1, 1, 2, 2, 1, 3, 4}), {0, 1, 2, 3, 5}, 0.5);
    REQUIRE(times.size() == 3);
    // Fitness 7, 5 and 2 of survivors from 7 to 2: weights 1.1, 0.7 and 0.1.
    CHECK(times.at(0) == Approx(10'000 * 1.1 / 1.9).margin(300));
    CHECK(times.at(2) == Approx(10'000 * 0.7 / 1.9).margin(300));
    CHECK(times.at(5) == Approx(10'000 * 0.1 / 1.9).margin(150));
}

TEST_CASE("equally fit lines are tuned equally often", "[evolution][tuning]") {
    const auto all = test::individuals({1.0, 1.0});
    const auto times = counts({std::make_shared<const Individual>(*all[0]),
                               [&] {
                                   Individual other = *all[1];
                                   other.line = 5;
                                   return std::make_shared<const Individual>(other);
                               }()},
                              {0, 1}, 1.0);
    REQUIRE(times.size() == 2);
    CHECK(times.at(0) == Approx(10'000).margin(300));
}

TEST_CASE("without tuned offspring no random number is drawn", "[evolution][tuning]") {
    RandomStream stream(7);
    for (const auto& parent :
         draw_tuned_parents(ranking({1, 2}), std::vector<std::size_t>{0, 1}, 50, 0.0, stream))
        CHECK_FALSE(parent.has_value());
    CHECK(stream.bits() == RandomStream(7).bits());
}

TEST_CASE("tuned children copy the structure of their one parent and say how they were made",
          "[evolution][tuning]") {
    test::FakeBackend backend;
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = 60;
    settings->population.tuned = GENERATE(0.0, 0.5, 1.0);
    Evolution evolution(settings, kinds());
    EvaluationProgress progress;
    REQUIRE(evolution.evaluate(backend, progress, {}));
    evolution.breed();
    int tuned = 0;
    int children = 0;
    for (const IndividualPtr& one : evolution.population()) {
        if (one->born != 1) continue;
        ++children;
        if (one->method != "tuning") continue;
        ++tuned;
        REQUIRE(one->mother.get());
        const Individual& mother = *one->mother.get();
        CHECK(one->parents == std::array<std::uint64_t, 2>{mother.uid, 0});
        CHECK(one->line == mother.line);
        CHECK(one->genome->nodes.size() == mother.genome->nodes.size());
        REQUIRE(one->mutations.size() == 1);
        CHECK(one->mutations[0].operator_id == "tuning");
    }
    CHECK(tuned >= (settings->population.tuned - 0.25) * children);
    CHECK(tuned <= (settings->population.tuned + 0.25) * children);
    CHECK((tuned == children || settings->population.tuned < 1.0));
    CHECK((tuned == 0 || settings->population.tuned > 0.0));
}
