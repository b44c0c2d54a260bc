// The scores that offspring need to survive, for early termination.
#include "evolution/selections/survival_thresholds.h"

#include "core/random.h"
#include "evolution/selections/survival.h"
#include "support/catch.h"
#include "support/individuals.h"
#include "support/kinds.h"

#include <algorithm>

using namespace cambrian;
using test::kinds;
using test::ranking;

namespace {

const SelectionKind& truncation() {
    return *kinds().selections.find("truncation");
}

// Ten survivors of twenty, two of a line and of a plan.
ExperimentSettings ten_survivors() {
    ExperimentSettings settings;
    settings.population.size = 20;
    settings.population.survival = 0.5;
    settings.selection.line_share = 0.2;
    settings.selection.plan_copies = 2;
    return settings;
}

std::vector<IndividualPtr> chosen(const std::vector<IndividualPtr>& ranked,
                                  const std::vector<std::size_t>& places) {
    std::vector<IndividualPtr> kept;
    for (const std::size_t place : places)
        kept.push_back(ranked[place]);
    return kept;
}

// Returns creatures of random lines, plans and scores, best first.
std::vector<IndividualPtr> random_ranking(int count, int kinds_of_each, RandomStream& stream) {
    std::vector<std::uint64_t> lines;
    std::vector<std::uint64_t> plans;
    for (int i = 0; i < count; ++i) {
        lines.push_back(stream.below(static_cast<std::uint64_t>(kinds_of_each)));
        plans.push_back(stream.below(static_cast<std::uint64_t>(kinds_of_each)));
    }
    return ranking(lines, plans);
}

}  // namespace

TEST_CASE("without limits every offspring needs the score of the worst survivor",
          "[evolution][termination]") {
    ExperimentSettings settings = ten_survivors();
    settings.selection.line_share = 1.0;
    settings.selection.plan_copies = 0;
    const auto survivors = ranking({1, 1, 2}, {1, 2, 3});
    const SurvivalThresholds thresholds(survivors, settings, truncation());
    CHECK(thresholds.of(1, 1) == 1.0);
    CHECK(thresholds.of(9, 9) == 1.0);
}

TEST_CASE("with limits an offspring needs the score of those in its way",
          "[evolution][termination]") {
    // Scores 10 to 1. Line 1 and its plan 1 are full, so is line 2, and line 3 is not.
    const auto survivors = ranking({1, 1, 2, 2, 3, 4, 5, 6, 7, 8}, {1, 1, 2, 3, 4, 4, 5, 6, 7, 8});
    const SurvivalThresholds thresholds(survivors, ten_survivors(), truncation());
    CHECK(thresholds.of(1, 1) == 9.0);
    CHECK(thresholds.of(1, 9) == Approx(0.8 * 9.0));
    CHECK(thresholds.of(2, 3) == Approx(0.8 * 7.0));
    CHECK(thresholds.of(3, 4) == 0.5);  // others are of plan 4 as well
    CHECK(thresholds.of(9, 9) == 0.5);
}

TEST_CASE("no score is known without survivors, nor where the least fit matter",
          "[evolution][termination]") {
    const auto survivors = ranking({1, 2, 3}, {1, 2, 3});
    CHECK_FALSE(SurvivalThresholds().of(1, 1));
    CHECK_FALSE(SurvivalThresholds({}, ten_survivors(), truncation()).of(1, 1));
    const SelectionKind& map = *kinds().selections.find("map-elites");
    CHECK_FALSE(SurvivalThresholds(survivors, ten_survivors(), map).of(1, 1));
}

TEST_CASE("no score is known while a survivor did not complete its trial, or with several trials",
          "[evolution][termination]") {
    auto survivors = ranking({1, 2, 3}, {1, 2, 3});
    CHECK(SurvivalThresholds(survivors, ten_survivors(), truncation()).of(1, 1));
    ExperimentSettings several = ten_survivors();
    several.world.trial.trials = 2;
    CHECK_FALSE(SurvivalThresholds(survivors, several, truncation()).of(1, 1));
    Individual rejected = *survivors.back();
    rejected.result.outcome = Outcome::kRejected;
    survivors.back() = std::make_shared<const Individual>(rejected);
    CHECK_FALSE(SurvivalThresholds(survivors, ten_survivors(), truncation()).of(1, 1));
}

TEST_CASE("a score to survive is below the worst survivor's, also where that is negative",
          "[evolution][termination]") {
    auto survivors = ranking({1, 2, 3}, {1, 2, 3});
    Individual worst = *survivors.back();
    worst.result.fitness = -0.8;
    survivors.back() = std::make_shared<const Individual>(worst);
    CHECK(SurvivalThresholds(survivors, ten_survivors(), truncation()).of(9, 9) == Approx(-1.2));
}

TEST_CASE("limits that were dropped for want of others do not count", "[evolution][termination]") {
    const auto survivors = ranking({1, 1, 1, 1}, {1, 1, 1, 1});
    CHECK(SurvivalThresholds(survivors, ten_survivors(), truncation()).of(1, 1) == 0.5);
}

TEST_CASE("an offspring below enough survivors of its line and plan never survives",
          "[evolution][termination]") {
    const ExperimentSettings settings = ten_survivors();
    RandomStream stream(11);
    int doomed = 0;
    for (int round = 0; round < 2000; ++round) {
        const auto before = random_ranking(60, 6, stream);
        const auto survivors = chosen(before, truncated(before, settings));
        const SurvivalThresholds thresholds(survivors, settings, truncation());
        std::vector<IndividualPtr> next = survivors;
        for (const IndividualPtr& one : random_ranking(30, 6, stream)) {
            Individual offspring = *one;
            offspring.uid += 1000;
            offspring.result.phenotype += 1000;
            offspring.result.fitness *= stream.uniform(0.1, 2.0);
            next.push_back(std::make_shared<const Individual>(offspring));
        }
        std::sort(next.begin(), next.end(),
                  [](const IndividualPtr& a, const IndividualPtr& b) { return better(*a, *b); });
        const auto later = chosen(next, truncated(next, settings));
        for (const IndividualPtr& one : next) {
            const auto in_the_way =
                std::count_if(survivors.begin(), survivors.end(), [&](const IndividualPtr& old) {
                    return old->line == one->line && old->result.plan == one->result.plan &&
                           old->result.fitness > one->result.fitness;
                });
            const bool is_offspring = one->uid >= 1000;
            const bool below = one->result.fitness < thresholds.of(one->line, one->result.plan);
            if (!is_offspring || !below || in_the_way < settings.selection.plan_copies) continue;
            ++doomed;
            CHECK(std::find(later.begin(), later.end(), one) == later.end());
        }
    }
    CHECK(doomed > 500);
}
