#include "picking/picking_desk.h"

#include "evolution/backends/thread_pool_backend.h"
#include "picking/body_backend.h"
#include "picking/creatures.h"
#include "support/catch.h"

#include <chrono>
#include <stdexcept>
#include <thread>

using namespace cambrian;
using test::BodyBackend;
using test::default_settings;
using test::kinds;

namespace {

// Waits up to a minute for a snapshot that satisfies the condition.
template <class Condition>
std::shared_ptr<const PickingSnapshot> wait_for(PickingDesk& desk, Condition condition) {
    for (int i = 0; i < 60000; ++i) {
        const auto snapshot = desk.latest();
        if (condition(*snapshot)) return snapshot;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    FAIL("the desk never got there");
    return nullptr;
}

std::shared_ptr<const PickingSnapshot> wait_for_grids(PickingDesk& desk, std::size_t count) {
    return wait_for(desk, [&](const PickingSnapshot& shown) { return shown.tree.size() == count; });
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

TEST_CASE("a desk shows what it was given and breeds ahead", "[picking][desk][threads]") {
    PickingDesk desk(default_settings(), kinds(), std::make_unique<BodyBackend>());
    REQUIRE(desk.latest());
    CHECK(desk.latest()->tree.empty());
    REQUIRE(desk.send(StartFromCreatures{{test::hopper()}}));
    wait_for_grids(desk, 1);
    REQUIRE(desk.send(TogglePick{0, 4}));
    wait_for(desk, [](const PickingSnapshot& shown) { return shown.children_ready; });
    REQUIRE(desk.send(BreedPicks{}));
    const auto bred = wait_for_grids(desk, 2);
    CHECK(bred->status == PickingStatus::kOpen);
}

TEST_CASE("old snapshots stay as they were", "[picking][desk][threads]") {
    PickingDesk desk(default_settings(), kinds(), std::make_unique<BodyBackend>());
    desk.send(StartFromCreatures{});
    const auto first = wait_for_grids(desk, 1);
    const auto before = hashes(first->tree.current());
    desk.send(ReplaceUnpicked{});
    const auto second = wait_for_grids(desk, 2);
    CHECK(first->tree.size() == 1);
    CHECK(hashes(first->tree.current()) == before);
    CHECK(&first->tree.node(0) == &second->tree.node(0));
}

TEST_CASE("commands while it breeds are heard and do not change what is bred",
          "[picking][desk][threads]") {
    const auto grid_after = [](bool disturbed) {
        PickingDesk desk(default_settings(), kinds(), slow_backend());
        desk.send(StartFromCreatures{{test::hopper()}});
        wait_for_grids(desk, 1);
        desk.send(TogglePick{0, 4});
        desk.send(BreedPicks{});
        for (int i = 0; disturbed && i < 20; ++i) {
            desk.send(UnpinCreature{});
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return hashes(wait_for_grids(desk, 2)->tree.current());
    };
    CHECK(grid_after(false) == grid_after(true));
}

TEST_CASE("a decision can be undone while its grid is bred", "[picking][desk][threads]") {
    PickingDesk desk(default_settings(), kinds(), slow_backend());
    desk.send(StartFromCreatures{{test::hopper()}});
    wait_for_grids(desk, 1);
    desk.send(TogglePick{0, 4});
    desk.send(AskEvolution{1000});
    wait_for(desk,
             [](const PickingSnapshot& shown) { return shown.status == PickingStatus::kEvolving; });
    desk.send(CancelDecision{});
    const auto shown = wait_for(
        desk, [](const PickingSnapshot& each) { return each.status == PickingStatus::kOpen; });
    CHECK(shown->tree.size() == 1);
    CHECK(shown->picks == std::vector<std::size_t>{4});
}

TEST_CASE("a back-end that throws leaves a message and a desk that goes on",
          "[picking][desk][threads]") {
    auto backend = std::make_unique<BodyBackend>();
    int left = 20;
    backend->adjust = [left](const Genome&, EvaluationResult&) mutable {
        if (--left == 0) throw std::runtime_error("out of luck");
    };
    PickingDesk desk(default_settings(), kinds(), std::move(backend));
    desk.send(StartFromCreatures{});
    const auto failed =
        wait_for(desk, [](const PickingSnapshot& shown) { return !shown.message.empty(); });
    CHECK(failed->message == "breeding failed: out of luck");
    CHECK(failed->status == PickingStatus::kOpen);
    desk.send(StartFromCreatures{});
    wait_for_grids(desk, 1);
}

TEST_CASE("a desk stops in the middle of breeding", "[picking][desk][threads]") {
    PickingDesk desk(default_settings(), kinds(), slow_backend());
    desk.send(StartFromCreatures{{test::hopper()}});
    wait_for_grids(desk, 1);
    desk.send(TogglePick{0, 0});
    desk.send(AskEvolution{1000});
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    SUCCEED("the destructor returns long before 60 000 creatures are evaluated");
}

TEST_CASE("real trials fill a grid on one worker and on two alike", "[picking][desk][threads]") {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->world.trial.duration = 0.5;
    const auto grid_on = [&](std::size_t workers) {
        PickingDesk desk(settings, kinds(), make_thread_pool_backend(kinds(), workers));
        desk.send(StartFromCreatures{{test::hopper()}});
        wait_for_grids(desk, 1);
        desk.send(TogglePick{0, 5});
        desk.send(TogglePick{0, 2});
        desk.send(BreedPicks{});
        return hashes(wait_for_grids(desk, 2)->tree.current());
    };
    CHECK(grid_on(1) == grid_on(2));
}
