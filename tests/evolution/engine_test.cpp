#include "evolution/engine.h"

#include "support/catch.h"
#include "support/fake_backend.h"
#include "support/kinds.h"

#include <chrono>
#include <thread>

using namespace cambrian;
using test::FakeBackend;
using test::kinds;

namespace {

SettingsPtr settings_of(int size) {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = size;
    return settings;
}

// Waits for a snapshot that satisfies the condition; gives up after a minute.
template <class Condition>
std::shared_ptr<const EvolutionSnapshot> wait_for(EvolutionEngine& engine, Condition condition) {
    for (int i = 0; i < 60000; ++i) {
        const auto snapshot = engine.latest();
        if (condition(*snapshot)) return snapshot;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    FAIL("the engine never got there");
    return nullptr;
}

bool finished(const EvolutionSnapshot& snapshot, std::size_t generations) {
    return snapshot.history.size() >= generations;
}

}  // namespace

TEST_CASE("an engine begins paused with an empty history", "[evolution][engine][threads]") {
    EvolutionEngine engine(settings_of(20), kinds(), std::make_unique<FakeBackend>());
    const auto snapshot = engine.latest();
    REQUIRE(snapshot);
    CHECK(snapshot->status == EngineStatus::kPaused);
    CHECK(snapshot->history.empty());
    CHECK(snapshot->journal.size() == 1);
}

TEST_CASE("a step runs exactly one generation", "[evolution][engine][threads]") {
    EvolutionEngine engine(settings_of(20), kinds(), std::make_unique<FakeBackend>());
    for (std::size_t steps = 1; steps <= 3; ++steps) {
        REQUIRE(engine.send(StepGeneration{}));
        const auto snapshot = wait_for(engine, [&](const EvolutionSnapshot& s) {
            return finished(s, steps) && s.status == EngineStatus::kPaused;
        });
        CHECK(snapshot->history.size() == steps);
        CHECK(snapshot->generation == steps);
        CHECK(snapshot->champions.size() == steps);
        CHECK(snapshot->population.size() == 20);
    }
}

TEST_CASE("evolution runs until paused", "[evolution][engine][threads]") {
    EvolutionEngine engine(settings_of(20), kinds(), std::make_unique<FakeBackend>());
    REQUIRE(engine.send(ResumeEvolution{}));
    wait_for(engine, [](const EvolutionSnapshot& s) { return finished(s, 5); });
    REQUIRE(engine.send(PauseEvolution{}));
    const auto paused = wait_for(
        engine, [](const EvolutionSnapshot& s) { return s.status == EngineStatus::kPaused; });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    CHECK(engine.latest()->history.size() == paused->history.size());
}

TEST_CASE("commands during a run do not change what evolves", "[evolution][engine][threads]") {
    const auto champion_after = [](std::size_t generations, bool disturbed) {
        EvolutionEngine engine(settings_of(30), kinds(), std::make_unique<FakeBackend>());
        engine.send(ResumeEvolution{});
        while (disturbed && !finished(*engine.latest(), generations)) {
            engine.send(PauseEvolution{});
            engine.send(ResumeEvolution{});
        }
        const auto snapshot =
            wait_for(engine, [&](const EvolutionSnapshot& s) { return finished(s, generations); });
        return snapshot->champions[generations - 1].individual->genome_hash;
    };
    CHECK(champion_after(6, false) == champion_after(6, true));
}

TEST_CASE("changed settings are in the journal and in force", "[evolution][engine][threads]") {
    EvolutionEngine engine(settings_of(20), kinds(), std::make_unique<FakeBackend>());
    auto changed = std::make_shared<ExperimentSettings>(*settings_of(20));
    changed->world.environment.gravity = 1.62;
    REQUIRE(engine.send(ChangeSettings{changed}));
    const auto snapshot =
        wait_for(engine, [](const EvolutionSnapshot& s) { return s.journal.size() == 2; });
    CHECK(snapshot->settings->world.environment.gravity == 1.62);
    REQUIRE(engine.send(StartExperiment{settings_of(24), {}}));
    const auto anew =
        wait_for(engine, [](const EvolutionSnapshot& s) { return s.experiment == 2; });
    CHECK(anew->journal.size() == 1);
    CHECK(anew->settings->population.size == 24);
}

TEST_CASE("a back-end that throws pauses the run with a message", "[evolution][engine][threads]") {
    auto backend = std::make_unique<FakeBackend>();
    backend->fitness = [](const Genome&) -> double { throw std::runtime_error("out of luck"); };
    EvolutionEngine engine(settings_of(20), kinds(), std::move(backend));
    REQUIRE(engine.send(ResumeEvolution{}));
    const auto snapshot = wait_for(
        engine, [](const EvolutionSnapshot& s) { return s.status == EngineStatus::kFailed; });
    CHECK(snapshot->failure == "out of luck");
}

TEST_CASE("an engine stops in the middle of a generation", "[evolution][engine][threads]") {
    auto backend = std::make_unique<FakeBackend>();
    backend->fitness = [](const Genome&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        return 1.0;
    };
    EvolutionEngine engine(settings_of(20000), kinds(), std::move(backend));
    engine.send(ResumeEvolution{});
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    SUCCEED("the destructor returns long before 20000 trials are done");
}
