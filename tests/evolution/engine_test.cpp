#include "evolution/engine/engine.h"

#include "support/catch.h"
#include "support/fake_backend.h"
#include "support/kinds.h"
#include "support/wait_for.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <semaphore>
#include <thread>
#include <vector>

using namespace cambrian;
using test::FakeBackend;
using test::kinds;
using test::wait_for;

namespace {

SettingsPtr settings_of(int size) {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = size;
    return settings;
}

bool finished(const EvolutionSnapshot& snapshot, std::size_t generations) {
    return snapshot.history.size() >= generations;
}

// A meeting point for a back-end in the middle of its work and the test that replaces it. Each
// waits for the other up to a minute.
class HandOver {
public:
    void wait_for_another() {
        reached_.release();
        (void)go_on_.try_acquire_for(std::chrono::minutes(1));
    }
    bool reached() { return reached_.try_acquire_for(std::chrono::minutes(1)); }
    void go_on() { go_on_.release(); }

private:
    std::binary_semaphore reached_{0};
    std::binary_semaphore go_on_{0};
};

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
        engine.send(StepGeneration{});
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
    engine.send(ResumeEvolution{});
    wait_for(engine, [](const EvolutionSnapshot& s) { return finished(s, 5); });
    engine.send(PauseEvolution{});
    const auto paused = wait_for(
        engine, [](const EvolutionSnapshot& s) { return s.status == EngineStatus::kPaused; });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    CHECK(engine.latest()->history.size() == paused->history.size());
}

namespace {

// Counts the champions that are stored, and remembers the last.
class CrownLog final : public ExperimentLog {
public:
    Status begin(const SettingsPtr&, const std::vector<GenomePtr>&) override { return {}; }
    Status note(const NotedCommand&) override { return {}; }
    Status record(const Evolution&) override { return {}; }
    Status crown(const JudgedIndividual& champion) override {
        const std::lock_guard guard(mutex_);
        crowned_.push_back(champion);
        return {};
    }
    std::vector<JudgedIndividual> crowned() const {
        const std::lock_guard guard(mutex_);
        return crowned_;
    }

private:
    mutable std::mutex mutex_;
    std::vector<JudgedIndividual> crowned_;
};

}  // namespace

TEST_CASE("the champion of a pause is the audited one that a run without a window ends with",
          "[evolution][engine][threads]") {
    const auto half_of_best = [](double fitness, const ExperimentSettings& settings) {
        return settings.world.scene.tolerance > 1e-6 || fitness < 4.0 ? fitness : 0.5 * fitness;
    };
    const SettingsPtr settings = settings_of(60);
    FakeBackend plain;
    plain.under = half_of_best;
    const Evolution evolution = test::evolved(settings, plain, 2);
    EvaluationProgress progress;
    const IndividualPtr expected = *evolution.confirmed_champion(plain, progress, {});
    REQUIRE(expected->uid != evolution.population().front()->uid);

    auto backend = std::make_unique<FakeBackend>();
    backend->under = half_of_best;
    const auto log = std::make_shared<CrownLog>();
    EvolutionEngine engine(settings, kinds(), std::move(backend), log);
    for (std::size_t step = 1; step <= 2; ++step) {
        engine.send(StepGeneration{});
        wait_for(engine, [&](const EvolutionSnapshot& s) {
            return finished(s, step) && !s.champions.back().individual->result.scores.empty() &&
                   s.champions.back().individual->result.scores.size() > 3;
        });
    }
    const auto paused = engine.latest();
    CHECK(paused->status == EngineStatus::kPaused);
    const JudgedIndividual& champion = paused->champions.back();
    CHECK(champion.individual->uid == expected->uid);
    CHECK(champion.individual->result.scores == expected->result.scores);
    CHECK(champion.individual->result.fitness == expected->result.fitness);
    CHECK(champion.generation == 1);
    const auto crowned = log->crowned();
    REQUIRE(crowned.size() == 2);
    CHECK(crowned.back().individual == champion.individual);
    CHECK(crowned.back().generation == 1);
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

TEST_CASE("another back-end takes over in mid-generation without a change of what evolves",
          "[evolution][engine][backend][threads]") {
    static constexpr std::size_t kGenerations = 6;
    static constexpr int kJudgedByEach = 5;
    const auto champions_of = [](std::size_t changes) {
        // Every back-end but the last evaluates a few creatures and waits until the next one is in
        // use.
        std::vector<std::unique_ptr<HandOver>> hand_overs;
        std::vector<std::shared_ptr<FakeBackend>> backends;
        for (std::size_t i = 0; i <= changes; ++i) {
            backends.push_back(std::make_shared<FakeBackend>());
            if (i == changes) break;
            HandOver& hand_over = *hand_overs.emplace_back(std::make_unique<HandOver>());
            backends.back()->fitness = [&hand_over, judged = 0](const Genome& genome) mutable {
                if (++judged == kJudgedByEach) hand_over.wait_for_another();
                return test::total_length(genome);
            };
        }
        EvolutionEngine engine(settings_of(30), kinds(), backends.front());
        engine.send(ResumeEvolution{});
        for (std::size_t i = 0; i < changes; ++i) {
            REQUIRE(hand_overs[i]->reached());
            engine.send(UseBackend{backends[i + 1]});
            hand_overs[i]->go_on();
        }
        const auto snapshot =
            wait_for(engine, [](const EvolutionSnapshot& s) { return finished(s, kGenerations); });
        for (std::size_t i = 0; i < changes; ++i)
            CHECK(backends[i]->evaluations == kJudgedByEach);
        std::vector<std::uint64_t> champions;
        for (std::size_t i = 0; i < kGenerations; ++i)
            champions.push_back(snapshot->champions[i].individual->genome_hash);
        return champions;
    };
    CHECK(champions_of(0) == champions_of(20));
}

TEST_CASE("a generation's wall time leaves out pauses", "[evolution][engine][threads]") {
    auto backend = std::make_shared<FakeBackend>();
    backend->fitness = [](const Genome& genome) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return test::total_length(genome);
    };
    EvolutionEngine engine(settings_of(20), kinds(), backend);
    engine.send(StepGeneration{});
    wait_for(engine, [](const EvolutionSnapshot& s) {
        return finished(s, 1) && s.status == EngineStatus::kPaused;
    });
    const auto paused = std::chrono::steady_clock::now();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    engine.send(StepGeneration{});
    const auto snapshot =
        wait_for(engine, [](const EvolutionSnapshot& s) { return finished(s, 2); });
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - paused;
    REQUIRE(snapshot->wall_times.size() == 2);
    CHECK(snapshot->wall_times.front() >= 0.02);
    CHECK(snapshot->wall_times.back() > 0.0);
    CHECK(snapshot->wall_times.back() <= since.count() - 0.3);
}

TEST_CASE("changed settings are in the journal and in force", "[evolution][engine][threads]") {
    EvolutionEngine engine(settings_of(20), kinds(), std::make_unique<FakeBackend>());
    auto changed = std::make_shared<ExperimentSettings>(*settings_of(20));
    changed->world.environment.gravity = 1.62;
    engine.send(ChangeSettings{changed});
    const auto snapshot =
        wait_for(engine, [](const EvolutionSnapshot& s) { return s.journal.size() == 2; });
    CHECK(snapshot->settings->world.environment.gravity == 1.62);
    engine.send(StartExperiment{settings_of(24), {}});
    const auto anew =
        wait_for(engine, [](const EvolutionSnapshot& s) { return s.experiment == 2; });
    CHECK(anew->journal.size() == 1);
    CHECK(anew->settings->population.size == 24);
}

TEST_CASE("a back-end that throws pauses the run with a message", "[evolution][engine][threads]") {
    auto backend = std::make_unique<FakeBackend>();
    backend->fitness = [](const Genome&) -> double { throw std::runtime_error("out of luck"); };
    EvolutionEngine engine(settings_of(20), kinds(), std::move(backend));
    engine.send(ResumeEvolution{});
    const auto snapshot = wait_for(
        engine, [](const EvolutionSnapshot& s) { return s.status == EngineStatus::kFailed; });
    CHECK(snapshot->failure == "out of luck");
}

TEST_CASE("a back-end that cannot go on pauses the run with its reason",
          "[evolution][engine][backend][threads]") {
    auto backend = std::make_shared<FakeBackend>();
    backend->failure = "two workers with other bits";
    backend->most_a_call = 0;
    EvolutionEngine engine(settings_of(20), kinds(), backend);
    engine.send(ResumeEvolution{});
    const auto snapshot = wait_for(
        engine, [](const EvolutionSnapshot& s) { return s.status == EngineStatus::kFailed; });
    CHECK(snapshot->failure == "two workers with other bits");
    engine.send(UseBackend{std::make_shared<FakeBackend>()});
    engine.send(ResumeEvolution{});
    wait_for(engine, [](const EvolutionSnapshot& s) { return finished(s, 2); });
}

TEST_CASE("an engine stops in the middle of a generation", "[evolution][engine][threads]") {
    std::atomic<int> trials = 0;
    HandOver first;
    {
        auto backend = std::make_unique<FakeBackend>();
        backend->fitness = [&](const Genome&) {
            if (trials++ == 0) first.wait_for_another();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            return 1.0;
        };
        EvolutionEngine engine(settings_of(20000), kinds(), std::move(backend));
        engine.send(ResumeEvolution{});
        REQUIRE(first.reached());
        first.go_on();
    }
    CHECK(trials < 20000);
}
