#include "persist/preserve/preserve_file.h"
#include "preserve/engine/preserve_engine.h"
#include "simulator/simulator_version.h"
#include "support/temporary_directory.h"
#include "support/wait_for.h"
#include "worlds.h"

#include <catch2/catch.hpp>

namespace cambrian {
namespace {

using namespace test;

bool answered(const PreservePicture& picture, std::uint64_t id) {
    return !picture.news.empty() && picture.news.back().id >= id;
}

TEST_CASE("a preserve on its thread plays, pauses, steps and obeys", "[preserve][threads]") {
    PreserveEngine engine({begun(small_world(), {eater(0.0)}), nullptr, {}}, {.workers = 2});
    const auto first = engine.latest();
    REQUIRE(first->residents.size() == 10);
    CHECK_FALSE(first->playing);
    CHECK(first->area.width == 12.0);
    engine.send(StepPreserve{});
    const auto stepped = wait_for(engine, [](const auto& picture) { return picture.tick == 1; });

    engine.send(Intervene{{.what = intervention::kAdd, .x = 1.0, .genome = eater(1.0)}});
    engine.send(Intervene{{.what = intervention::kRemove, .number = 2}});
    engine.send(Intervene{{.what = intervention::kRemove, .number = 2}});
    engine.send(Intervene{{.what = intervention::kFeed}});
    const auto changed = wait_for(engine, [](const auto& picture) { return answered(picture, 4); });
    CHECK(changed->news[0].number == 11);
    CHECK(changed->news[1].problem.empty());
    CHECK(changed->news[2].problem == "creature 2 is not alive");
    CHECK(changed->plants.size() == stepped->plants.size() + 10);
    CHECK(changed->find(2) == nullptr);
    REQUIRE(changed->find(11) != nullptr);
    CHECK(changed->find(11)->parts.size() == changed->find(11)->phenotype->parts.size());
    REQUIRE(changed->died->size() == 1);
    CHECK(changed->died->front().cause == DeathCause::kRemoved);

    engine.send(PacePreserve{kFullSpeed});
    engine.send(PlayPreserve{true});
    const auto later = wait_for(engine, [](const auto& picture) { return picture.tick > 650; });
    CHECK(later->playing);
    CHECK(later->series->back().tick == later->tick / kTicksPerRow * kTicksPerRow);
    engine.send(PlayPreserve{false});
    const auto paused = wait_for(engine, [](const auto& picture) { return !picture.playing; });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    CHECK(engine.latest()->tick == paused->tick);
}

TEST_CASE("pictures have the signals of the brain that is watched, while it lives",
          "[preserve][threads]") {
    PreserveEngine engine({begun(small_world(), {eater(0.0)}), nullptr, {}}, {.workers = 1});
    CHECK(engine.latest()->brain.creature == 0);
    engine.send(WatchBrain{3});
    const auto watched =
        wait_for(engine, [](const auto& picture) { return picture.brain.creature == 3; });
    const ResidentPicture* creature = watched->find(3);
    REQUIRE(creature != nullptr);
    CHECK(watched->brain.slots.size() == creature->phenotype->network.slot_count());
    CHECK(watched->brain.outputs.size() == creature->phenotype->network.outputs.size());
    REQUIRE_FALSE(watched->brain.outputs.empty());
    for (int tick = 1; tick <= 10; ++tick) {
        engine.send(StepPreserve{});
        wait_for(engine, [&](const auto& picture) {
            return picture.tick == static_cast<std::uint64_t>(tick);
        });
    }
    CHECK(engine.latest()->brain.outputs != watched->brain.outputs);
    engine.send(Intervene{{.what = intervention::kRemove, .number = 3}});
    const auto removed = wait_for(engine, [](const auto& picture) { return answered(picture, 1); });
    CHECK(removed->brain.creature == 0);
    CHECK(removed->brain.slots.empty());
}

// A log whose writing ends by an exception.
class BrokenLog final : public PreserveLog {
public:
    Status write(const Chronicle& /*chronicle*/, const Preserve& /*preserve*/) override {
        throw std::runtime_error("out of luck");
    }
    Status keep_pins(const Pins& /*pins*/) override { return {}; }
    std::vector<std::uint64_t> snapshots() const override { return {}; }
};

TEST_CASE("a preserve that an exception stopped neither goes on nor changes",
          "[preserve][threads]") {
    PreserveEngine engine({begun(small_world(), {eater(0.0)}), std::make_unique<BrokenLog>(), {}},
                          {.workers = 1});
    engine.send(PacePreserve{kFullSpeed});
    engine.send(PlayPreserve{true});
    const auto stopped = wait_for(engine, [](const auto& picture) { return picture.broken; });
    CHECK_FALSE(stopped->playing);
    CHECK(stopped->failure == "out of luck");
    CHECK(stopped->tick == kTicksPerSnapshot);
    engine.send(PlayPreserve{true});
    engine.send(StepPreserve{});
    engine.send(Intervene{{.what = intervention::kFeed}});
    const auto asked = wait_for(engine, [](const auto& picture) { return answered(picture, 1); });
    CHECK(asked->news.back().problem == "out of luck");
    CHECK(asked->tick == stopped->tick);
    CHECK(asked->failure == "out of luck");
}

TEST_CASE("a preserve goes at the pace that is asked for", "[preserve][threads]") {
    PreserveEngine engine({begun(small_world(), {eater(0.0)}), nullptr, {}}, {.workers = 1});
    engine.send(PacePreserve{0.1});
    engine.send(PlayPreserve{true});
    const Stopwatch watch;
    wait_for(engine, [](const auto& picture) { return picture.tick >= 2; });
    CHECK(watch.seconds() > 1.9 / 6.0);  // a tenth of real time: 6 ticks a second
}

TEST_CASE("a preserve that is closed goes on where it was left", "[preserve][threads]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    const auto settings = std::make_shared<const ExperimentSettings>(small_world());
    auto preserve = begun(*settings, {eater(0.0)});
    auto file = PreserveFile::create(path, {settings, {eater(0.0)}, std::string(kSimulatorVersion)},
                                     preserve->take_chronicle(), *preserve, kinds());
    REQUIRE(file);
    std::uint64_t tick = 0;
    {
        PreserveEngine engine({std::move(preserve), *std::move(file), {}}, {.workers = 1});
        engine.send(PacePreserve{kFullSpeed});
        engine.send(PlayPreserve{true});
        wait_for(engine, [](const auto& picture) { return picture.tick > 100; });
        engine.send(PlayPreserve{false});
        engine.send(Intervene{{.what = intervention::kFeed}});
        tick = wait_for(engine, [](const auto& picture) { return answered(picture, 1); })->tick;
        CHECK(engine.latest()->snapshots->size() == 1);
    }
    auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    CHECK(opened->state.tick == tick);
    const auto saved = load_preserve(path, kinds());
    REQUIRE(saved->interventions.size() == 2);
    CHECK(saved->interventions.front().what == intervention::kFeed);
    CHECK(saved->snapshots.size() == 2);
}

}  // namespace
}  // namespace cambrian
