#include "evolution/evolution.h"

#include "genome/random_genome.h"
#include "support/catch.h"
#include "support/fake_backend.h"
#include "support/kinds.h"

#include <set>

using namespace cambrian;
using test::FakeBackend;
using test::kinds;

namespace {

std::shared_ptr<ExperimentSettings> small_settings(int size = 40) {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = size;
    settings->seed = 5;
    return settings;
}

void run(Evolution& evolution, EvaluationBackend& backend, int generations) {
    EvaluationProgress progress;
    for (int i = 0; i < generations; ++i) {
        if (i > 0) evolution.breed();
        REQUIRE(evolution.evaluate(backend, progress, {}));
    }
}

std::vector<std::uint64_t> hashes(const Evolution& evolution) {
    std::vector<std::uint64_t> all;
    for (const IndividualPtr& one : evolution.population())
        all.push_back(one->genome_hash);
    return all;
}

}  // namespace

TEST_CASE("the best fitness never falls while the world stays the same", "[evolution]") {
    Evolution evolution(small_settings(), kinds());
    FakeBackend backend;
    run(evolution, backend, 25);
    const auto& history = evolution.history();
    for (std::size_t i = 1; i < history.size(); ++i)
        CHECK(history[i].best >= history[i - 1].best);
    CHECK(history.back().best > 1.5 * history.front().best);
}

TEST_CASE("the same seed gives the same generations, another seed others", "[evolution]") {
    const auto settings = small_settings();
    Evolution first(settings, kinds());
    Evolution second(settings, kinds());
    auto other_settings = small_settings();
    other_settings->seed = 6;
    Evolution other(other_settings, kinds());
    FakeBackend backend;
    for (Evolution* each : {&first, &second, &other})
        run(*each, backend, 8);
    CHECK(hashes(first) == hashes(second));
    CHECK(hashes(first) != hashes(other));
}

TEST_CASE("an interrupted generation goes on where it stopped", "[evolution]") {
    Evolution straight(small_settings(), kinds());
    Evolution broken(small_settings(), kinds());
    FakeBackend backend;
    run(straight, backend, 3);
    const int evaluations = std::exchange(backend.evaluations, 0);
    EvaluationProgress progress;
    for (int i = 0; i < 3; ++i) {
        if (i > 0) broken.breed();
        backend.stop_after = 5;
        REQUIRE_FALSE(broken.evaluate(backend, progress, {}));
        CHECK_FALSE(broken.evaluated());
        REQUIRE(broken.evaluate(backend, progress, {}));
    }
    CHECK(hashes(straight) == hashes(broken));
    CHECK(backend.evaluations == evaluations);
}

TEST_CASE("survivors are not evaluated again until the world changes", "[evolution]") {
    auto settings = small_settings(50);
    Evolution evolution(settings, kinds());
    FakeBackend backend;
    run(evolution, backend, 1);
    CHECK(backend.evaluations <= 50);
    backend.evaluations = 0;
    evolution.breed();
    EvaluationProgress progress;
    REQUIRE(evolution.evaluate(backend, progress, {}));
    CHECK(backend.evaluations <= 40);

    auto moon = std::make_shared<ExperimentSettings>(*settings);
    moon->world.environment.gravity = 1.62;
    evolution.replace_settings(moon);
    evolution.breed();
    backend.evaluations = 0;
    REQUIRE(evolution.evaluate(backend, progress, {}));
    const std::set<std::uint64_t> distinct = [&] {
        const auto all = hashes(evolution);
        return std::set<std::uint64_t>(all.begin(), all.end());
    }();
    CHECK(backend.evaluations == static_cast<int>(distinct.size()));
}

TEST_CASE("a generation keeps its size under any mix of settings", "[evolution]") {
    for (const int size : {2, 3, 17, 60}) {
        auto settings = small_settings(size);
        settings->population.immigrants = size / 3;
        settings->population.max_clones = 1;
        Evolution evolution(settings, kinds());
        FakeBackend backend;
        run(evolution, backend, 6);
        CHECK(evolution.population().size() == static_cast<std::size_t>(size));
    }
}

TEST_CASE("founders given by hand fill a population with their mutants", "[evolution]") {
    RandomStream stream(3);
    const auto founder = std::make_shared<const Genome>(
        random_genome(FounderSettings{}, kinds().creature.catalog, stream));
    Evolution evolution(small_settings(30), kinds(), {founder});
    CHECK(*evolution.population().front()->genome == *founder);
    CHECK(evolution.population().size() == 30);
    const auto all = hashes(evolution);
    const std::set<std::uint64_t> distinct(all.begin(), all.end());
    CHECK(distinct.size() > 10);
    CHECK(distinct.size() < 30);  // a quarter of the mutants are copies
}

TEST_CASE("an injected creature lives in the next generation", "[evolution]") {
    Evolution evolution(small_settings(), kinds());
    FakeBackend backend;
    run(evolution, backend, 1);
    Genome giant = *evolution.population().front()->genome;
    giant.nodes[0].length = 1.59;
    const auto injected = std::make_shared<const Genome>(giant);
    evolution.inject(injected);
    evolution.breed();
    const auto found =
        std::any_of(evolution.population().begin(), evolution.population().end(),
                    [&](const IndividualPtr& one) { return one->genome == injected; });
    CHECK(found);
}

TEST_CASE("offspring name their parents, method and mutations", "[evolution]") {
    Evolution evolution(small_settings(), kinds());
    FakeBackend backend;
    run(evolution, backend, 4);
    int changed = 0;
    for (const IndividualPtr& one : evolution.population()) {
        if (one->born == 0) continue;
        CHECK(one->parents[0] != 0);
        CHECK(kinds().breeding.find(one->method) != nullptr);
        changed += one->mutations.empty() ? 0 : 1;
    }
    CHECK(changed > 0);
}
