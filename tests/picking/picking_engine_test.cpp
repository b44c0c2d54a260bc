#include "picking/picking_engine.h"

#include "evolution/backends/thread_pool_backend.h"
#include "picking/body_backend.h"
#include "picking/creatures.h"
#include "support/catch.h"
#include "support/wait_for.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

using namespace cambrian;
using test::BodyBackend;
using test::default_settings;
using test::kinds;
using test::wait_for;

namespace {

std::shared_ptr<const PickingSnapshot> wait_for_grids(PickingEngine& engine, std::size_t count) {
    return wait_for(engine,
                    [&](const PickingSnapshot& shown) { return shown.tree.size() == count; });
}

// Returns a back-end whose evaluations take 20 ms each.
std::unique_ptr<BodyBackend> slow_backend() {
    auto backend = std::make_unique<BodyBackend>();
    backend->adjust = [](const Genome&, EvaluationResult&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    };
    return backend;
}

std::vector<std::uint64_t> hashes(const GridNode& grid) {
    std::vector<std::uint64_t> all;
    for (const IndividualPtr& each : grid.creatures)
        all.push_back(each->genome_hash);
    return all;
}

}  // namespace

TEST_CASE("the picking engine publishes the first grid and breeds the next one ahead",
          "[picking][engine][threads]") {
    PickingEngine engine(default_settings(), kinds(), std::make_unique<BodyBackend>());
    REQUIRE(engine.latest());
    CHECK(engine.latest()->tree.empty());
    engine.send(StartFromCreatures{{test::hopper()}});
    wait_for_grids(engine, 1);
    engine.send(TogglePick{0, 4});
    wait_for(engine, [](const PickingSnapshot& shown) { return shown.children_ready; });
    engine.send(BreedPicks{});
    const auto bred = wait_for_grids(engine, 2);
    CHECK(bred->status == PickingStatus::kOpen);
}

TEST_CASE("old snapshots do not change", "[picking][engine][threads]") {
    PickingEngine engine(default_settings(), kinds(), std::make_unique<BodyBackend>());
    engine.send(StartFromCreatures{});
    const auto first = wait_for_grids(engine, 1);
    const auto before = hashes(first->tree.current());
    engine.send(ReplaceUnpicked{});
    const auto second = wait_for_grids(engine, 2);
    CHECK(first->tree.size() == 1);
    CHECK(hashes(first->tree.current()) == before);
    CHECK(&first->tree.node(0) == &second->tree.node(0));
}

TEST_CASE("commands during breeding are accepted and do not change its result",
          "[picking][engine][threads]") {
    const auto grid_after = [](bool disturbed) {
        PickingEngine engine(default_settings(), kinds(), slow_backend());
        engine.send(StartFromCreatures{{test::hopper()}});
        wait_for_grids(engine, 1);
        engine.send(TogglePick{0, 4});
        engine.send(BreedPicks{});
        for (int i = 0; disturbed && i < 20; ++i) {
            engine.send(UnpinCreature{});
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return hashes(wait_for_grids(engine, 2)->tree.current());
    };
    CHECK(grid_after(false) == grid_after(true));
}

TEST_CASE("a decision can be undone while its grid is bred", "[picking][engine][threads]") {
    PickingEngine engine(default_settings(), kinds(), slow_backend());
    engine.send(StartFromCreatures{{test::hopper()}});
    wait_for_grids(engine, 1);
    engine.send(TogglePick{0, 4});
    engine.send(AskEvolution{1000});
    wait_for(engine,
             [](const PickingSnapshot& shown) { return shown.status == PickingStatus::kEvolving; });
    engine.send(CancelDecision{});
    const auto shown = wait_for(
        engine, [](const PickingSnapshot& each) { return each.status == PickingStatus::kOpen; });
    CHECK(shown->tree.size() == 1);
    CHECK(shown->picks == std::vector<std::size_t>{4});
}

TEST_CASE("the picking engine reports a back-end that throws and continues to work",
          "[picking][engine][threads]") {
    auto backend = std::make_unique<BodyBackend>();
    int left = 20;
    backend->adjust = [left](const Genome&, EvaluationResult&) mutable {
        if (--left == 0) throw std::runtime_error("out of luck");
    };
    PickingEngine engine(default_settings(), kinds(), std::move(backend));
    engine.send(StartFromCreatures{});
    const auto failed =
        wait_for(engine, [](const PickingSnapshot& shown) { return !shown.message.empty(); });
    CHECK(failed->message == "breeding failed: out of luck");
    CHECK(failed->status == PickingStatus::kOpen);
    engine.send(StartFromCreatures{});
    wait_for_grids(engine, 1);
}

TEST_CASE("the picking engine can be stopped during breeding", "[picking][engine][threads]") {
    std::atomic<int> trials = 0;
    {
        auto backend = std::make_unique<BodyBackend>();
        backend->adjust = [&](const Genome&, EvaluationResult&) {
            ++trials;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        };
        PickingEngine engine(default_settings(), kinds(), std::move(backend));
        engine.send(StartFromCreatures{{test::hopper()}});
        wait_for_grids(engine, 1);
        engine.send(TogglePick{0, 0});
        engine.send(AskEvolution{1000});
        wait_for(engine, [](const PickingSnapshot& shown) {
            return shown.status == PickingStatus::kEvolving;
        });
    }
    CHECK(trials < 20000);
}

TEST_CASE("a grid of real trials is the same on one worker and on two",
          "[picking][engine][threads]") {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->world.trial.duration = 0.5;
    const auto grid_on = [&](std::size_t workers) {
        PickingEngine engine(settings, kinds(), make_thread_pool_backend(kinds(), workers));
        engine.send(StartFromCreatures{{test::hopper()}});
        wait_for_grids(engine, 1);
        engine.send(TogglePick{0, 5});
        engine.send(TogglePick{0, 2});
        engine.send(BreedPicks{});
        return hashes(wait_for_grids(engine, 2)->tree.current());
    };
    CHECK(grid_on(1) == grid_on(2));
}
