// The methods of evolution/README.md 2, each tested by what distinguishes it.
#include "evolution/individual/map_axis.h"
#include "evolution/selections/selection.h"
#include "support/catch.h"
#include "support/individuals.h"
#include "support/kinds.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

using namespace cambrian;

namespace {

using Change = std::function<void(Individual& individual, std::size_t place)>;

std::vector<IndividualPtr> ranked_by(
    std::size_t count, const std::function<double(double)>& score,
    const Change& change = [](Individual&, std::size_t) {}) {
    std::vector<double> fitness;
    for (std::size_t i = 0; i < count; ++i)
        fitness.push_back(score(static_cast<double>(i)));
    auto all = test::individuals(fitness);
    for (std::size_t i = 0; i < count; ++i) {
        Individual changed = *all[i];
        change(changed, i);
        all[i] = std::make_shared<const Individual>(changed);
    }
    return all;
}

double falling(double place) {
    return 1000.0 - place;
}

ExperimentSettings with(const std::string& method, int size) {
    ExperimentSettings settings;
    settings.selection.method = method;
    settings.population.size = size;
    return settings;
}

SelectionResult select(const std::vector<IndividualPtr>& ranked, const ExperimentSettings& settings,
                       SelectionMemory& memory, std::uint64_t seed = 3) {
    RandomStream stream(seed);
    return test::kinds()
        .selections.find(settings.selection.method)
        ->select(ranked, settings, memory, stream);
}

SelectionResult select(const std::vector<IndividualPtr>& ranked, const ExperimentSettings& settings,
                       std::uint64_t seed = 3) {
    SelectionMemory memory;
    return select(ranked, settings, memory, seed);
}

std::size_t children_of(const SelectionResult& result, std::size_t place) {
    return static_cast<std::size_t>(
        std::count(result.first_parents.begin(), result.first_parents.end(), place));
}

bool survives(const SelectionResult& result, std::size_t place) {
    return std::find(result.survivors.begin(), result.survivors.end(), place) !=
           result.survivors.end();
}

}  // namespace

TEST_CASE("every selection keeps the best, breeds from given weights and fills its places",
          "[evolution][selection]") {
    for (const SelectionKind& kind : test::kinds().selections.all()) {
        for (const int size : {2, 3, 50}) {
            for (const int immigrants : {0, 1, 1000}) {
                ExperimentSettings settings = with(kind.id, size);
                settings.population.immigrants = immigrants;
                const auto result =
                    select(ranked_by(static_cast<std::size_t>(size), falling), settings);
                CAPTURE(kind.id, size, immigrants);
                CHECK(survives(result, 0));
                CHECK(std::is_sorted(result.survivors.begin(), result.survivors.end()));
                CHECK(result.partner_weights.size() == static_cast<std::size_t>(size));
                const std::size_t total =
                    result.survivors.size() + result.first_parents.size() + result.immigrants;
                CHECK(total >= static_cast<std::size_t>(size));
                CHECK(total <= 2 * static_cast<std::size_t>(size));
                for (const std::size_t parent : result.first_parents)
                    CHECK(result.partner_weights.at(parent) > 0.0);
            }
        }
    }
}

TEST_CASE("no selection lets creatures in without a completed trial while there are others",
          "[evolution][selection]") {
    const auto outcome = GENERATE(Outcome::kStoppedEarly, Outcome::kRejected,
                                  Outcome::kDisqualified, Outcome::kDiverged);
    // Scores of completed trials are negative; the others have 0 or more.
    auto ranked = ranked_by(
        60, [](double place) { return -1.0 - place; },
        [&](Individual& individual, std::size_t place) {
            if (place < 40) return;
            individual.result.outcome = outcome;
            individual.result.fitness = 60.0 - static_cast<double>(place);
            individual.body_born = 7;
            individual.result.mass = 1e3;
        });
    const auto before = ranked;
    std::reverse(ranked.begin(), ranked.end());
    std::sort(ranked.begin(), ranked.end(),
              [](const auto& a, const auto& b) { return better(*a, *b); });
    CHECK(ranked == before);
    for (const SelectionKind& kind : test::kinds().selections.all()) {
        const auto result = select(ranked, with(kind.id, 30));
        CAPTURE(kind.id);
        CHECK(result.survivors.back() < 40);
        for (const std::size_t parent : result.first_parents)
            CHECK(parent < 40);
        for (std::size_t place = 40; place < 60; ++place)
            CHECK(result.partner_weights[place] == 0.0);
    }
}

TEST_CASE("novelty counts a completed trial as better than any other", "[evolution][selection]") {
    auto settings = with("novelty", 3);
    settings.selection.own["novelty-neighbors"] = 2;
    SelectionMemory memory;
    const auto alike = [](Individual& individual, std::size_t place) {
        individual.result.mass = place == 2 ? 2.0 : 1.0;
    };
    // One in the archive was rejected, as files of older versions may have it.
    const auto archived = ranked_by(
        2, [](double) { return 0.0; },
        [](Individual& individual, std::size_t) {
            individual.uid += 100;
            individual.result.mass = 1.0;
            individual.result.outcome = Outcome::kRejected;
        });
    memory.archive = archived;
    const auto ranked = ranked_by(
        3, [](double place) { return -0.1 - 0.1 * place; }, alike);
    CHECK(survives(select(ranked, settings, memory), 0));
    for (const IndividualPtr& novel : memory.archive) {
        const bool old = std::find(archived.begin(), archived.end(), novel) != archived.end();
        CHECK((old || novel->result.outcome == Outcome::kCompleted));
    }
}

TEST_CASE("a generation of disqualified creatures still has a next one", "[evolution][selection]") {
    const auto ranked = ranked_by(
        20, [](double) { return 0.0; },
        [](Individual& individual, std::size_t) {
            individual.result.outcome = Outcome::kDisqualified;
        });
    for (const SelectionKind& kind : test::kinds().selections.all()) {
        const auto result = select(ranked, with(kind.id, 20));
        CAPTURE(kind.id);
        CHECK_FALSE(result.survivors.empty());
        CHECK_FALSE(result.first_parents.empty());
    }
}

TEST_CASE("by rank, the best of S breeds S times as often as the worst, whatever the scores",
          "[evolution][selection]") {
    for (const double base : {1.01, 10.0}) {
        const auto ranked = ranked_by(100, [base](double place) { return std::pow(base, -place); });
        const auto result = select(ranked, with("rank", 100));
        REQUIRE(result.survivors.size() == 20);
        for (std::size_t i = 0; i < 20; ++i)
            CHECK(result.partner_weights[i] == Approx(20.0 - static_cast<double>(i)));
        // 80 places are distributed over a sum of ranks of 210.
        CHECK(children_of(result, 0) >= 7);
        CHECK(children_of(result, 0) <= 8);
        CHECK(children_of(result, 19) <= 1);
    }
}

TEST_CASE("tournaments of three are won as often as chance has it", "[evolution][selection]") {
    const auto settings = with("tournament", 20000);
    const auto ranked = ranked_by(20000, falling, [](Individual& individual, std::size_t place) {
        individual.genome_hash = place;
    });
    ExperimentSettings few = settings;
    few.population.survival = 10.0 / 20000.0;
    const auto result = select(ranked, few);
    REQUIRE(result.survivors.size() == 10);
    double chi_square = 0.0;
    for (std::size_t i = 0; i < 10; ++i) {
        const double above = std::pow(static_cast<double>(10 - i) / 10.0, 3);
        const double below = std::pow(static_cast<double>(9 - i) / 10.0, 3);
        const double expected = (above - below) * static_cast<double>(result.first_parents.size());
        const double off = static_cast<double>(children_of(result, i)) - expected;
        chi_square += off * off / expected;
        CHECK(result.partner_weights[i] == Approx(above - below));
    }
    CHECK(chi_square < 33.72);  // quantile for 9 degrees of freedom, p = 1e-4
}

TEST_CASE("tournaments of all keep only the elites and let anybody breed",
          "[evolution][selection]") {
    ExperimentSettings settings = with("tournament", 200);
    settings.selection.own["tournament-of-all"] = true;
    settings.selection.own["tournament-size"] = 2;
    settings.selection.elites = 3;
    const auto result = select(ranked_by(200, falling), settings);
    CHECK(result.survivors == std::vector<std::size_t>{0, 1, 2});
    CHECK(result.first_parents.size() == 197);
    CHECK(*std::max_element(result.first_parents.begin(), result.first_parents.end()) > 100);
}

TEST_CASE("roulette gives everyone its share of f - mean + 2 sd", "[evolution][selection]") {
    const auto ranked = ranked_by(100, falling);
    const auto result = select(ranked, with("roulette", 100));
    CHECK(result.survivors.size() == 2);
    const double sd = std::sqrt((100.0 * 100.0 - 1.0) / 12.0);
    double total = 0.0;
    for (std::size_t i = 0; i < 100; ++i)
        total += std::fmax(0.0, 49.5 - static_cast<double>(i) + 2.0 * sd);
    for (std::size_t i = 0; i < 100; ++i) {
        const double weight = 49.5 - static_cast<double>(i) + 2.0 * sd;
        CHECK(result.partner_weights[i] == Approx(weight));
        const double share = 98.0 * weight / total;
        CHECK(static_cast<double>(children_of(result, i)) >= std::floor(share));
        CHECK(static_cast<double>(children_of(result, i)) <= std::ceil(share));
    }
    const auto equals = ranked_by(50, [](double) { return 1.0; });
    const auto drawn = select(equals, with("roulette", 50));
    for (std::size_t i = 0; i < 50; ++i)
        CHECK(children_of(drawn, i) <= 1);
}

TEST_CASE("MAP-Elites keeps the fittest of every cell and breeds a full batch",
          "[evolution][selection]") {
    const auto ranked = ranked_by(96, falling, [](Individual& individual, std::size_t place) {
        individual.result.parts = 1 + static_cast<int>(place % 8);
        individual.result.mass = place % 16 < 8 ? 0.1 : 1.0;
    });
    const auto settings = with("map-elites", 96);
    const auto result = select(ranked, settings);
    CHECK(result.survivors.size() == 16);
    CHECK(result.survivors.back() == 15);  // the first creature of each cell, since fitness falls
    CHECK(result.first_parents.size() == 96);
    CHECK(result.partner_weights[0] == Approx(1.1));
    CHECK(result.partner_weights[15] == Approx(0.1 + 985.0 / 1000.0));
}

TEST_CASE("only a strictly fitter creature takes over a cell", "[evolution][selection]") {
    const auto ranked = ranked_by(
        2, [](double) { return 1.0; },
        [](Individual& individual, std::size_t place) {
            individual.born = place == 0 ? 5 : 2;  // the older creature took the cell first
        });
    CHECK(select(ranked, with("map-elites", 2)).survivors == std::vector<std::size_t>{1});
}

TEST_CASE("novelty keeps the odd one out although it is the worst", "[evolution][selection]") {
    const auto ranked = ranked_by(80, falling, [](Individual& individual, std::size_t place) {
        individual.result.mass = place == 79 ? 50.0 : 0.5 + 1e-3 * static_cast<double>(place % 7);
        individual.result.behavior.movable_joints = place == 79 ? 14 : 2;
    });
    const auto result = select(ranked, with("novelty", 10));
    CHECK(result.survivors.size() == 10);
    CHECK(survives(result, 79));
    CHECK(survives(result, 0));
    CHECK(result.first_parents.size() == 10);
}

TEST_CASE("the novelty archive gains the novel and adapts its threshold",
          "[evolution][selection]") {
    SelectionMemory memory;
    const auto settings = with("novelty", 40);
    std::uint64_t next_uid = 1;
    const auto generation = [&](std::uint32_t born, double spread) {
        const auto ranked = ranked_by(40, falling, [&](Individual& individual, std::size_t place) {
            individual.uid = next_uid++;
            individual.born = born;
            individual.result.mass = std::exp(spread * static_cast<double>(place));
        });
        select(ranked, settings, memory);
    };
    generation(0, 0.1);
    const double first = memory.threshold;
    const std::size_t kept = memory.archive.size();
    CHECK(first >= 1.0);  // the standard threshold
    for (std::uint32_t born = 1; born <= 10; ++born)
        generation(born, 0.0);  // all equal, so nothing is novel
    CHECK(memory.archive.size() == kept);
    CHECK(memory.threshold == Approx(0.95 * first));
    memory.threshold = 1e-3;
    generation(11, 0.1);
    CHECK(memory.archive.size() > kept + 4);
    CHECK(memory.threshold == Approx(1.2e-3));
}

TEST_CASE("age protection keeps what no younger creature beats", "[evolution][selection]") {
    const auto ranked = ranked_by(60, falling, [](Individual& individual, std::size_t place) {
        individual.body_born = place < 50 ? 1 : 9;  // ten new bodies, all less fit
    });
    const auto result = select(ranked, with("age-protection", 20));
    CHECK(result.survivors.size() == 20);
    CHECK(survives(result, 0));
    CHECK(survives(result, 50));
    CHECK(result.first_parents.size() == 19);
    CHECK(result.immigrants == 1);
}
