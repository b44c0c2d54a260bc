#include "studio/experiment/experiment_controller.h"

#include "studio_fixture.h"
#include "studio_run.h"

#include <algorithm>

namespace cambrian {
namespace {

using test::small_experiment;
using test::StudioRun;

TEST_CASE("finding a setting brings the settings back into the window", "[studio][experiment]") {
    StudioRun run;
    ViewState hidden = run.studio.view();
    hidden.panels.left = false;
    run.ask(ChangeView{hidden});
    run.ask(FindSetting{});
    CHECK(run.studio.view().panels.left);
    CHECK(run.studio.frame_context().experiment.find_asked == 1);
}

TEST_CASE("a new run can begin with the creature on display", "[studio][experiment]") {
    StudioRun run;
    run.ask(StartFromShown{});  // no creature is displayed, so it has no effect
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const GenomePtr shown = run.studio.frame_context().viewer.playback.exhibit().genome();
    run.ask(StartFromShown{});
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] {
        const EvolutionSnapshot& snapshot = run.studio.frame_context().experiment.snapshot;
        return snapshot.experiment == 2 && snapshot.champions.size() == 1;
    }));
    const auto& population = run.studio.frame_context().experiment.snapshot.population;
    CHECK(std::any_of(population.begin(), population.end(),
                      [&](const IndividualPtr& one) { return one->genome == shown; }));
    CHECK(std::all_of(population.begin(), population.end(),
                      [](const IndividualPtr& one) { return one->method == "imported"; }));
}

TEST_CASE("an edited world acts on the viewer at once and on the engine when the edit ends",
          "[studio][experiment]") {
    StudioRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    ExperimentSettings moon = run.studio.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    CHECK(run.studio.frame_context().viewer.playback.creature().replay().environment().gravity ==
          1.62);
    CHECK(run.studio.frame_context().experiment.snapshot.settings->world.environment.gravity ==
          9.81);
    run.ask(FinishEdit{});
    CHECK(run.frames_until([&] {
        return run.studio.frame_context().experiment.snapshot.settings->world.environment.gravity ==
               1.62;
    }));
    CHECK(run.studio.frame_context().experiment.snapshot.journal.size() == 2);
}

TEST_CASE("an edit of anything but the world leaves the displayed world alone",
          "[studio][experiment]") {
    StudioRun run;
    run.studio.show_founders();
    ExperimentSettings moon = run.studio.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.ask(FinishEdit{});
    run.studio.show_founders();
    const Environment before =
        run.studio.frame_context().viewer.playback.creature().replay().environment();
    ExperimentSettings larger = run.studio.frame_context().experiment.editor.draft();
    larger.population.size = 12;
    run.ask(EditSettings{larger, "population.size"});
    run.ask(FinishEdit{});
    CHECK(run.studio.frame_context().viewer.playback.creature().replay().environment() == before);
    CHECK(before.gravity == 1.62);
}

TEST_CASE("a new run from the present creatures begins with them", "[studio][experiment]") {
    StudioRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const auto experiment = run.studio.frame_context().experiment.snapshot.experiment;
    run.ask(StartNewRun{true});
    REQUIRE(run.frames_until([&] {
        return run.studio.frame_context().experiment.snapshot.experiment == experiment + 1;
    }));
    CHECK(run.studio.frame_context().experiment.snapshot.generation == 0);
    CHECK(run.champions() == 0);
}

namespace {

// Begins a new run and returns its seed and the genomes it begins with, evaluated.
std::pair<std::uint64_t, std::vector<std::uint64_t>> run_begun(StudioRun& run,
                                                               const StartNewRun& request) {
    const auto experiment = run.studio.frame_context().experiment.snapshot.experiment;
    run.ask(request);
    REQUIRE(run.frames_until([&] {
        return run.studio.frame_context().experiment.snapshot.experiment == experiment + 1;
    }));
    test::finish_generations(run, 1);
    const EvolutionSnapshot& snapshot = run.studio.frame_context().experiment.snapshot;
    CHECK(run.studio.frame_context().experiment.editor.draft().seed == snapshot.settings->seed);
    std::vector<std::uint64_t> genomes;
    for (const IndividualPtr& one : snapshot.population)
        genomes.push_back(one->genome_hash);
    return {snapshot.settings->seed, genomes};
}

}  // namespace

TEST_CASE("a new run has a new seed, or the same one if that is asked for",
          "[studio][experiment]") {
    StudioRun run;
    const auto first = run_begun(run, {.same_seed = true});
    CHECK(first.first == 1);
    const auto second = run_begun(run, {});
    CHECK(second.first != first.first);
    CHECK(second.second != first.second);
    const auto again = run_begun(run, {.same_seed = true});
    CHECK(again == second);
    const auto third = run_begun(run, {});
    CHECK(third.first != second.first);
    ExperimentSettings typed = run.studio.frame_context().experiment.editor.draft();
    typed.seed = 1;
    run.ask(EditSettings{typed, "run.seed"});
    run.ask(FinishEdit{});
    CHECK(run_begun(run, {}) == first);
}

TEST_CASE("undo also reverts an edit in the engine", "[studio][experiment]") {
    StudioRun run;
    ExperimentSettings edited = run.studio.frame_context().experiment.editor.draft();
    edited.population.size = 9;
    run.ask(EditSettings{edited, "population.size"});
    run.ask(FinishEdit{});
    REQUIRE(run.frames_until([&] {
        return run.studio.frame_context().experiment.snapshot.settings->population.size == 9;
    }));
    run.ask(UndoEdit{});
    CHECK(run.frames_until([&] {
        return run.studio.frame_context().experiment.snapshot.settings->population.size == 6;
    }));
}

TEST_CASE("evolution that ran goes on after one mode was left for another and back",
          "[studio][experiment]") {
    StudioRun run;
    const auto status = [&] { return run.studio.frame_context().experiment.snapshot.status; };
    run.ask(ToggleEvolution{});
    REQUIRE(run.frames_until([&] { return status() == EngineStatus::kRunning; }));
    run.ask(ToggleHandPicking{});
    REQUIRE(run.frames_until([&] { return status() == EngineStatus::kPaused; }));
    // Leaves the mode and enters it again within one frame, as when a preserve is opened.
    run.ask(ToggleHandPicking{});
    run.ask(ToggleHandPicking{});
    for (int frames = 0; frames < 50; ++frames)
        run.studio.update(0.0, 0.001);
    run.ask(ToggleHandPicking{});
    CHECK(run.frames_until([&] { return status() == EngineStatus::kRunning; }));
}

// Returns the number of generations of the run before the open one after it was opened.
std::size_t opened_run_before(StudioRun& run) {
    const auto experiment = run.studio.frame_context().experiment.snapshot.experiment;
    REQUIRE(run.studio.frame_context().experiment.previous_run);
    run.ask(OpenPreviousRun{});
    REQUIRE(run.frames_until([&] {
        return run.studio.frame_context().experiment.snapshot.experiment == experiment + 1;
    }));
    return run.champions();
}

// Begins a new run and waits until it is displayed.
template <class Begin>
void begin_run(StudioRun& run, Begin begin) {
    const auto experiment = run.studio.frame_context().experiment.snapshot.experiment;
    run.ask(begin);
    REQUIRE(run.frames_until([&] {
        return run.studio.frame_context().experiment.snapshot.experiment == experiment + 1;
    }));
}

TEST_CASE("the run before is opened from wherever it was kept", "[studio][experiment]") {
    StudioRun run;
    run.studio.remember_in(run.folder.path() / "state");
    REQUIRE(run.frames_until(
        [&] { return run.studio.frame_context().experiment.snapshot.experiment == 2; }));
    CHECK_FALSE(run.studio.frame_context().experiment.previous_run);
    test::finish_generations(run, 3);
    begin_run(run, StartFromShown{});
    SECTION("in the studio's own file until the next run has a generation") {
        CHECK(opened_run_before(run) == 3);
    }
    SECTION("beside it afterwards") {
        test::finish_generations(run, 1);
        CHECK(opened_run_before(run) == 3);
        CHECK(opened_run_before(run) == 1);
    }
    SECTION("under the name that the user gave it") {
        test::finish_generations(run, 2);
        const auto named = run.folder.path() / "named.cambrian";
        run.ask(SaveExperimentFile{named});
        REQUIRE(run.frames_until([&] { return std::filesystem::exists(named); }));
        REQUIRE(run.frames_until([&] { return run.log().find("\"saved\"") != std::string::npos; }));
        begin_run(run, StartNewRun{});
        test::finish_generations(run, 1);
        CHECK(opened_run_before(run) == 2);
    }
}

TEST_CASE("an edit that makes limits cross is taken back and never stored",
          "[studio][experiment]") {
    StudioRun run;
    const auto draft = [&] { return run.studio.frame_context().experiment.editor.draft(); };
    run.studio.remember_in(run.folder.path() / "state");
    const ExperimentSettings before = draft();
    ExperimentSettings crossed = before;
    crossed.founders.min_length = 1.5;
    crossed.founders.max_length = 0.4;
    run.ask(EditSettings{crossed, "body.min-length"});
    CHECK(run.studio.frame_context().experiment.editor.settled() == before);
    run.ask(FinishEdit{});
    CHECK(draft() == before);
    run.studio.update(0.0, 0.0);
    const Notice* notice = run.studio.frame_context().window.notice;
    REQUIRE(notice != nullptr);
    CHECK_THAT(notice->text, Catch::StartsWith("“") && Catch::Contains("taken back") &&
                                 !Catch::Contains("min-length") && !Catch::Contains("["));
    run.ask(RedoEdit{});
    CHECK(draft() == before);
}

TEST_CASE("undoing a new run goes back to the run before", "[studio][experiment]") {
    StudioRun run;
    run.studio.remember_in(run.folder.path() / "state");
    test::finish_generations(run, 2);
    const auto experiment = [&] {
        return run.studio.frame_context().experiment.snapshot.experiment;
    };
    const auto before = experiment();
    run.ask(StartNewRun{});
    REQUIRE(run.frames_until([&] { return experiment() == before + 1; }));
    CHECK(run.champions() == 0);
    CHECK(run.studio.frame_context().can_undo());
    run.ask(UndoEdit{});
    REQUIRE(run.frames_until([&] { return experiment() == before + 2; }));
    CHECK(run.champions() == 2);
    CHECK_FALSE(run.studio.frame_context().can_undo());
}

TEST_CASE("an edit after a new run is undone before it", "[studio][experiment]") {
    StudioRun run;
    test::finish_generations(run, 1);
    run.ask(StartNewRun{});
    ExperimentSettings edited = run.studio.frame_context().experiment.editor.draft();
    const int size = edited.population.size;
    edited.population.size = size + 3;
    run.ask(EditSettings{edited, "population.size"});
    run.ask(FinishEdit{});
    run.ask(UndoEdit{});
    CHECK(run.studio.frame_context().experiment.editor.draft().population.size == size);
}

TEST_CASE("one click evolves the creature on display in its own world", "[studio][experiment]") {
    StudioRun run;
    ExperimentSettings water = small_experiment();
    water.goal = "swimming";
    water.world.environment.has_ground = false;
    water.world.environment.gravity = 0.0;
    water.world.environment.viscosity_quadratic = 1.0;
    run.studio.show_founders();
    Exhibit swimmer = run.studio.frame_context().viewer.playback.exhibit();
    swimmer.creature.settings = std::make_shared<const ExperimentSettings>(water);
    run.ask(ShowExhibit{std::make_shared<const Exhibit>(swimmer)});
    const bool in_its_world = GENERATE(true, false);
    run.ask(EvolveShown{in_its_world});
    REQUIRE(run.frames_until([&] { return run.champions() >= 1; }));
    const EvolutionSnapshot& snapshot = run.studio.frame_context().experiment.snapshot;
    CHECK((snapshot.settings->goal == "swimming") == in_its_world);
    CHECK(snapshot.settings->world.environment.has_ground != in_its_world);
    CHECK(run.studio.view().newest_champion);
}

}  // namespace
}  // namespace cambrian
