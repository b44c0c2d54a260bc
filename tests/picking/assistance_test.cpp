#include "picking/assistance.h"

#include "picking/body_backend.h"
#include "picking/creatures.h"
#include "picking/handover.h"
#include "support/catch.h"

#include <algorithm>

using namespace cambrian;
using test::BodyBackend;
using test::kinds;

namespace {

Assistance assisted(int generations, const ExperimentSettings& settings = {},
                    std::uint32_t node = 2) {
    return {test::strangers(2), generations, node, settings, kinds()};
}

std::vector<IndividualPtr> elites_of(Assistance assistance) {
    BodyBackend backend;
    EvaluationProgress progress;
    int steps = 0;
    while (!assistance.done()) {
        REQUIRE(assistance.step(backend, progress, {}));
        REQUIRE(++steps <= assistance.generations() + 1);
    }
    CHECK(steps == assistance.generations() + 1);
    return assistance.elites();
}

std::vector<std::uint64_t> hashes(const std::vector<IndividualPtr>& creatures) {
    std::vector<std::uint64_t> all;
    for (const IndividualPtr& each : creatures)
        all.push_back(each->genome_hash);
    return all;
}

}  // namespace

TEST_CASE("assistance runs the requested generations and returns the better half",
          "[picking][assistance]") {
    const auto elites = elites_of(assisted(10));
    CHECK(elites.size() == 30);
    CHECK(std::is_sorted(elites.begin(), elites.end(),
                         [](const auto& a, const auto& b) { return better(*a, *b); }));
    const auto seeds = elites_of(assisted(1));
    CHECK(elites.front()->result.fitness > seeds.front()->result.fitness);
}

TEST_CASE("assistance is reproducible for a grid and differs between grids",
          "[picking][assistance]") {
    const auto once = hashes(elites_of(assisted(3)));
    CHECK(once == hashes(elites_of(assisted(3))));
    CHECK(once != hashes(elites_of(assisted(3, {}, 3))));
}

TEST_CASE("assistance drops scores that depend on the seed", "[picking][assistance]") {
    ExperimentSettings jittered;
    jittered.world.trial.trials = 2;
    for (const IndividualPtr& elite : elites_of(assisted(1, jittered)))
        CHECK_FALSE(elite->evaluated);
    for (const IndividualPtr& elite : elites_of(assisted(1)))
        CHECK(elite->evaluated);
}

TEST_CASE("picks can join an automatic population", "[picking][handover]") {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = 20;
    Evolution evolution(settings, kinds());
    BodyBackend backend;
    EvaluationProgress progress;
    REQUIRE(evolution.evaluate(backend, progress, {}));
    const auto picks = test::strangers(3, 77);
    for (EngineCommand& command : injection_of(picks))
        evolution.inject(std::get<InjectGenome>(command).genome);
    evolution.breed();
    for (const IndividualPtr& pick : picks) {
        CHECK(std::count_if(evolution.population().begin(), evolution.population().end(),
                            [&](const auto& each) { return each->genome == pick->genome; }) == 1);
    }
}
