#include "genome/creature_name.h"
#include "persist/creature/creature_file.h"
#include "studio_run.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace cambrian {
namespace {

using test::StudioRun;

// The studio, whose user picks by hand.
class PickingRun : public StudioRun {
public:
    // Counts no assertion, since waiting calls it as often as the threads are slow.
    const PickingSnapshot& picking() const {
        const FrameContext frame = studio.frame_context();
        if (frame.picking == nullptr) FAIL("the studio is not in selection by hand");
        return frame.picking->snapshot;
    }
    void enter(std::size_t grids) {
        ask(ToggleHandPicking{});
        wait_for_grids(grids);
    }
    void wait_for_grids(std::size_t grids) {
        REQUIRE(frames_until([&] { return picking().tree.size() == grids; }));
    }
    void pick(const std::vector<std::size_t>& cells) {
        for (const std::size_t cell : cells)
            ask(AskPicking{TogglePick{picking().tree.current().number, cell}});
        REQUIRE(frames_until([&] { return picking().picks == cells; }));
    }
    void breed() {
        const std::size_t grids = picking().tree.size();
        ask(AskPicking{BreedPicks{}});
        wait_for_grids(grids + 1);
    }
    void go_back() {
        const std::uint32_t present = picking().tree.current().number;
        ask(AskPicking{GoBack{}});
        REQUIRE(frames_until([&] { return picking().tree.current().number != present; }));
    }
    // Makes a request that begins a run, and waits until it has begun.
    template <class Request>
    void begin_run(const Request& request) {
        const auto experiment = [this] {
            return studio.frame_context().experiment.snapshot.experiment;
        };
        const std::uint64_t before = experiment();
        ask(request);
        REQUIRE(frames_until([&] { return experiment() == before + 1; }));
    }
    void run_generations(std::size_t count) {
        const std::size_t before = champions();
        for (std::size_t i = 1; i <= count; ++i) {
            ask(RunOneGeneration{});
            REQUIRE(frames_until([&] {
                return champions() == before + i &&
                       studio.frame_context().experiment.snapshot.status == EngineStatus::kPaused;
            }));
        }
    }
};

bool has_genome(const std::vector<IndividualPtr>& creatures, const GenomePtr& genome) {
    return std::any_of(creatures.begin(), creatures.end(),
                       [&](const IndividualPtr& each) { return each->genome == genome; });
}

TEST_CASE("a person picks, breeds, goes back and branches off", "[studio][controller][picking]") {
    PickingRun run;
    run.studio.show_founders();
    run.enter(1);
    CHECK(run.picking().tree.current().creatures.size() == 12);
    run.pick({1, 4, 6});
    run.breed();
    CHECK(run.picking().tree.current().picks == std::vector<std::size_t>{1, 4, 6});
    run.go_back();
    CHECK(run.picking().picks == std::vector<std::size_t>{1, 4, 6});
    run.ask(AskPicking{ClearPicks{}});
    run.pick({2});
    run.breed();
    REQUIRE(run.picking().tree.size() == 3);
    CHECK(run.picking().tree.node(1).parent == 0U);
    CHECK(run.picking().tree.node(2).parent == 0U);
    CHECK(run.picking().branches == 1);
    CHECK(run.log().find("{\"event\":\"hand-picking\",\"on\":true}") != std::string::npos);
    CHECK(run.log().find("\"origin\":\"bred from 3 picks\"") != std::string::npos);
}

TEST_CASE("creatures of the population can be picked, and automatic evolution keeps the tree",
          "[studio][controller][picking]") {
    PickingRun run;
    run.run_generations(1);
    run.enter(1);
    CHECK(run.picking().tree.current().origin == GridOrigin::kPopulation);
    run.ask(ToggleHandPicking{});
    CHECK(run.studio.frame_context().picking == nullptr);
    run.enter(1);  // there was no evolution meanwhile
    run.ask(ToggleHandPicking{});
    run.run_generations(1);
    run.enter(2);
    CHECK(run.picking().tree.current().parent == 0U);
}

TEST_CASE("picks join the next generation that is bred", "[studio][controller][picking]") {
    PickingRun run;
    run.run_generations(1);
    run.enter(1);
    run.pick({3});
    run.breed();
    run.pick({5});
    const GenomePtr picked = run.picking().tree.current().creatures[5]->genome;
    run.ask(HandOverPicks{PicksUse::kInject});
    CHECK(run.studio.frame_context().picking == nullptr);
    run.run_generations(2);  // one generation was bred before
    CHECK(has_genome(run.studio.frame_context().experiment.snapshot.population, picked));
}

TEST_CASE("a new run begins with the picks", "[studio][controller][picking]") {
    PickingRun run;
    run.studio.show_founders();
    run.enter(1);
    run.pick({5});
    const GenomePtr picked = run.picking().tree.current().creatures[5]->genome;
    run.begin_run(HandOverPicks{PicksUse::kFound});
    run.run_generations(1);
    CHECK(has_genome(run.studio.frame_context().experiment.snapshot.population, picked));
}

TEST_CASE("a new run begins without the grids of the run before", "[studio][controller][picking]") {
    PickingRun run;
    run.studio.show_founders();
    run.enter(1);
    run.pick({5});
    run.breed();
    run.ask(ToggleHandPicking{});
    run.begin_run(StartNewRun{});
    run.run_generations(1);
    run.enter(1);
    CHECK(run.picking().tree.current().origin == GridOrigin::kPopulation);
}

TEST_CASE("a new run ends picking by hand and begins without its grids",
          "[studio][controller][picking]") {
    PickingRun run;
    run.studio.show_founders();
    run.enter(1);
    run.pick({5});
    run.breed();
    run.begin_run(StartNewRun{});
    CHECK(run.frames_until([&] { return run.studio.frame_context().picking == nullptr; }));
    run.run_generations(1);
    run.enter(1);
    CHECK(run.picking().tree.current().origin == GridOrigin::kPopulation);
    CHECK(run.picking().picks.empty());
}

TEST_CASE("handing over without a pick says so and stays", "[studio][controller][picking]") {
    PickingRun run;
    run.studio.show_founders();
    run.enter(1);
    run.ask(HandOverPicks{});
    CHECK(run.frames_until([&] { return run.studio.frame_context().window.notice != nullptr; }));
    CHECK(run.studio.frame_context().picking != nullptr);
}

TEST_CASE("evolution rests while a person picks and goes on afterwards",
          "[studio][controller][picking]") {
    PickingRun run;
    const auto status = [&] { return run.studio.frame_context().experiment.snapshot.status; };
    run.ask(ToggleEvolution{});
    REQUIRE(run.frames_until([&] { return run.champions() > 0; }));
    run.ask(ToggleHandPicking{});
    REQUIRE(run.frames_until([&] { return status() == EngineStatus::kPaused; }));
    run.ask(ToggleEvolution{});
    run.ask(ToggleHandPicking{});
    CHECK(run.frames_until([&] { return status() == EngineStatus::kRunning; }));
}

TEST_CASE("a creature of the grid is shown alone and saved", "[studio][controller][picking]") {
    PickingRun run;
    run.studio.show_founders();
    run.enter(1);
    const GenomePtr genome = run.picking().tree.current().creatures[7]->genome;
    run.ask(ShowCell{7});
    run.ask(ShowCell{99});  // there is no such cell, so it has no effect
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().picking->single; }));
    CHECK(run.studio.frame_context().viewer.playback.exhibit().genome() == genome);
    run.ask(ShowGrid{});
    run.ask(SaveCell{7});
    CHECK(run.studio.frame_context().files.browser.open);
    const Exhibit& shown = run.studio.frame_context().viewer.playback.exhibit();
    CHECK(shown.title == "Creature 8 of grid 1");
    CHECK(shown.name() == creature_name(*genome));
    std::string stem = shown.name();
    std::transform(stem.begin(), stem.end(), stem.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    CHECK(run.studio.frame_context().files.browser.suggested_name == stem + ".creature.json");
    const auto path = run.folder.path() / "picked.creature.json";
    run.ask(SaveCreatureFile{path});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    const auto saved = load_creature(path, test::kinds());
    REQUIRE(saved);
    CHECK(saved->genome() == *genome);
}

TEST_CASE("a world changed while picking acts on the grid and evaluates the next one",
          "[studio][controller][picking]") {
    PickingRun run;
    run.studio.show_founders();
    run.enter(1);
    ExperimentSettings moon = run.studio.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.ask(FinishEdit{});
    REQUIRE(run.frames_until(
        [&] { return run.studio.frame_context().picking->motion.environment().gravity == 1.62; }));
    run.pick({0});
    run.breed();
    CHECK(run.picking().tree.current().settings->world.environment.gravity == 1.62);
}

}  // namespace
}  // namespace cambrian
