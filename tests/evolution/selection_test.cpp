#include "evolution/selections/selection.h"

#include "evolution/selections/survival.h"
#include "support/catch.h"
#include "support/individuals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace cambrian;

namespace {

std::vector<IndividualPtr> descending(std::size_t count) {
    std::vector<double> fitness;
    for (std::size_t i = 0; i < count; ++i)
        fitness.push_back(static_cast<double>(count - i));
    return test::individuals(fitness);
}

SelectionResult truncate(const std::vector<IndividualPtr>& ranked,
                         const ExperimentSettings& settings, std::uint64_t seed = 3) {
    RandomStream stream(seed);
    SelectionMemory memory;
    return builtin_selections().find("truncation")->select(ranked, settings, memory, stream);
}

EvaluationResult scored(double fitness, Outcome outcome) {
    EvaluationResult result;
    result.fitness = fitness;
    result.outcome = outcome;
    return result;
}

ExperimentSettings of_size(int size) {
    ExperimentSettings settings;
    settings.population.size = size;
    return settings;
}

}  // namespace

TEST_CASE("universal sampling gives everyone floor or ceiling of its share", "[evolution]") {
    RandomStream stream(11);
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> weights(1 + stream.below(30));
        for (double& weight : weights)
            weight = stream.uniform();
        weights[stream.below(weights.size())] += 0.5;
        const std::size_t count = stream.below(200);
        const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
        const auto picks = universal_sampling(weights, count, stream);
        REQUIRE(picks.size() == count);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const double share = weights[i] / total * static_cast<double>(count);
            const auto got = static_cast<double>(std::count(picks.begin(), picks.end(), i));
            REQUIRE(got >= std::floor(share - 1e-9));
            REQUIRE(got <= std::ceil(share + 1e-9));
        }
    }
}

TEST_CASE("truncation keeps the best fifth and fills the rest with offspring", "[evolution]") {
    const auto ranked = descending(100);
    const SelectionResult result = truncate(ranked, of_size(100));
    CHECK(result.survivors.size() == 20);
    CHECK(result.survivors.front() == 0);
    CHECK(result.survivors.back() == 19);
    CHECK(result.first_parents.size() == 80);
    CHECK(*std::max_element(result.first_parents.begin(), result.first_parents.end()) <= 19);
}

TEST_CASE("the best survivor breeds six times as often as the worst", "[evolution]") {
    const SelectionResult result = truncate(descending(100), of_size(100));
    CHECK(result.partner_weights[0] == Approx(6.0 * result.partner_weights[19]));
    CHECK(result.partner_weights[20] == 0.0);
}

TEST_CASE("equal fitness breeds equally", "[evolution]") {
    const auto ranked = test::individuals(std::vector<double>(50, 0.0));
    const SelectionResult result = truncate(ranked, of_size(50));
    std::set<std::size_t> parents(result.first_parents.begin(), result.first_parents.end());
    CHECK(parents.size() == 10);
}

TEST_CASE("at most max_clones of one phenotype survive", "[evolution]") {
    auto ranked = descending(50);
    for (std::size_t i = 1; i < 20; ++i) {
        Individual clone = *ranked[0];
        clone.uid = 100 + i;
        ranked[i] = std::make_shared<const Individual>(clone);
    }
    ExperimentSettings settings = of_size(50);
    for (const int most : {1, 2, 5}) {
        settings.population.max_clones = most;
        const SelectionResult result = truncate(ranked, settings);
        CHECK(result.survivors.size() == 10);
        CHECK(std::count_if(result.survivors.begin(), result.survivors.end(), [&](std::size_t i) {
                  return ranked[i]->result.phenotype == 0;
              }) == most);
    }
}

TEST_CASE("a population of two still has a survivor and an offspring", "[evolution]") {
    const SelectionResult result = truncate(descending(2), of_size(2));
    CHECK(result.survivors.size() == 1);
    CHECK(result.first_parents.size() == 1);
}

TEST_CASE("random immigrants take the places of offspring", "[evolution]") {
    ExperimentSettings settings = of_size(100);
    settings.population.immigrants = 30;
    CHECK(truncate(descending(100), settings).first_parents.size() == 50);
    settings.population.immigrants = 1000;
    CHECK(truncate(descending(100), settings).first_parents.empty());
}

TEST_CASE("the order of merit is total and puts invalid creatures last", "[evolution]") {
    auto all = test::individuals({1.0, 2.0, 2.0, 5.0});
    Individual cheat = *all[3];
    cheat.result.outcome = Outcome::kDisqualified;
    CHECK(better(*all[1], *all[0]));
    CHECK(better(*all[1], *all[2]));
    CHECK_FALSE(better(*all[2], *all[1]));
    CHECK(better(*all[0], cheat));
    CHECK_FALSE(better(cheat, *all[0]));
}

TEST_CASE("whoever came further in its trial is fitter, whatever the scores", "[evolution]") {
    const Outcome order[] = {Outcome::kCompleted, Outcome::kStoppedEarly, Outcome::kRejected,
                             Outcome::kDisqualified};
    for (int near = 0; near < 4; ++near) {
        for (int far = near + 1; far < 4; ++far) {
            CAPTURE(near, far);
            CHECK(fitter(scored(-5.0, order[near]), scored(5.0, order[far])));
            CHECK_FALSE(fitter(scored(5.0, order[far]), scored(-5.0, order[near])));
        }
    }
    CHECK(fitter(scored(-1.0, Outcome::kCompleted), scored(-2.0, Outcome::kCompleted)));
    CHECK_FALSE(fitter(scored(-1.0, Outcome::kCompleted), scored(-1.0, Outcome::kCompleted)));
}

TEST_CASE("rejected creatures never have more weight than completed ones of negative score",
          "[evolution]") {
    auto ranked = test::individuals({-0.2, -0.6, 0.0, 0.0});
    for (std::size_t i = 2; i < 4; ++i) {
        Individual rejected = *ranked[i];
        rejected.result.outcome = Outcome::kRejected;
        ranked[i] = std::make_shared<const Individual>(rejected);
    }
    const std::vector<std::size_t> all = {0, 1, 2, 3};
    CHECK(leads(ranked, all) == std::vector<double>{1.0, 0.0, 0.0, 0.0});
    CHECK(leads(ranked, std::vector<std::size_t>{1, 2}) == std::vector<double>{1.0, 0.0});
    CHECK(leads(ranked, std::vector<std::size_t>{2, 3}) == std::vector<double>{1.0, 1.0});
    ExperimentSettings settings = of_size(4);
    settings.population.survival = 0.5;
    CHECK(truncate(ranked, settings).survivors == std::vector<std::size_t>{0, 1});
}
