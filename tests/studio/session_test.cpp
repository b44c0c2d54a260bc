#include "session_run.h"

#include <algorithm>
#include <fstream>

namespace cambrian {
namespace {

using test::SessionRun;

TEST_CASE("a new run can begin with the creature on show", "[studio][session]") {
    SessionRun run;
    run.ask(StartFromShown{});  // nothing on show: nothing happens
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const GenomePtr shown = run.session.frame_context().playback.exhibit().genome;
    run.ask(StartFromShown{});
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] {
        const EvolutionSnapshot& snapshot = run.session.frame_context().snapshot;
        return snapshot.experiment == 2 && snapshot.champions.size() == 1;
    }));
    const auto& population = run.session.frame_context().snapshot.population;
    CHECK(std::any_of(population.begin(), population.end(),
                      [&](const IndividualPtr& one) { return one->genome == shown; }));
    CHECK(std::all_of(population.begin(), population.end(),
                      [](const IndividualPtr& one) { return one->method == "imported"; }));
}

TEST_CASE("one generation is evaluated, logged and its champion takes the stage",
          "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const FrameContext frame = run.session.frame_context();
    REQUIRE_FALSE(frame.playback.empty());
    CHECK(frame.playback.exhibit().genome == frame.snapshot.champions[0].individual->genome);
    CHECK(run.log().find("{\"event\":\"generation\",\"number\":0,\"best\":") != std::string::npos);
}

TEST_CASE("the score shown is the one the engine found, and the replay is verified",
          "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.session.frame_context().score != nullptr; }));
    const FrameContext frame = run.session.frame_context();
    const EvaluationResult& result = *frame.playback.exhibit().result;
    CHECK(frame.score->score.value == result.fitness);
    CHECK(frame.score->record.digest == result.digest);
}

TEST_CASE("a saved creature loads as the same creature", "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const GenomePtr genome = run.session.frame_context().playback.exhibit().genome;
    const auto path = run.folder.path() / "best.creature.json";
    run.ask(SaveCreatureFile{path});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] {
        return run.session.frame_context().playback.exhibit().source == ExhibitSource::kFile;
    }));
    CHECK(*run.session.frame_context().playback.exhibit().genome == *genome);
}

TEST_CASE("a file that cannot be opened is a notice and changes nothing", "[studio][session]") {
    SessionRun run;
    const auto path = run.folder.path() / "broken.creature.json";
    std::ofstream(path) << "{ not json";
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] { return run.session.frame_context().notice != nullptr; }));
    const Notice& notice = *run.session.frame_context().notice;
    CHECK(notice.kind == NoticeKind::kProblem);
    CHECK(notice.text.find("broken.creature.json") != std::string::npos);
    CHECK(run.session.frame_context().playback.empty());
}

TEST_CASE("an edited world is felt on stage at once and by the engine once let go",
          "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    ExperimentSettings moon = run.session.frame_context().editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    CHECK(run.session.frame_context().playback.environment().gravity == 1.62);
    CHECK(run.session.frame_context().snapshot.settings->world.environment.gravity == 9.81);
    run.ask(FinishEdit{});
    CHECK(run.frames_until([&] {
        return run.session.frame_context().snapshot.settings->world.environment.gravity == 1.62;
    }));
    CHECK(run.session.frame_context().snapshot.journal.size() == 2);
}

TEST_CASE("an edit of anything but the world leaves the stage's world alone", "[studio][session]") {
    SessionRun run;
    run.session.show_newcomer();
    ExperimentSettings moon = run.session.frame_context().editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.ask(FinishEdit{});
    run.session.show_newcomer();
    const Environment before = run.session.frame_context().playback.environment();
    ExperimentSettings larger = run.session.frame_context().editor.draft();
    larger.population.size = 12;
    run.ask(EditSettings{larger, "population.size"});
    run.ask(FinishEdit{});
    CHECK(run.session.frame_context().playback.environment() == before);
    CHECK(before.gravity == 1.62);
}

TEST_CASE("a new run from the present creatures begins with them", "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const auto experiment = run.session.frame_context().snapshot.experiment;
    run.ask(StartNewRun{true});
    REQUIRE(run.frames_until(
        [&] { return run.session.frame_context().snapshot.experiment == experiment + 1; }));
    CHECK(run.session.frame_context().snapshot.generation == 0);
    CHECK(run.champions() == 0);
}

TEST_CASE("undo takes an edit back from the engine too", "[studio][session]") {
    SessionRun run;
    ExperimentSettings edited = run.session.frame_context().editor.draft();
    edited.population.size = 9;
    run.ask(EditSettings{edited, "population.size"});
    run.ask(FinishEdit{});
    REQUIRE(run.frames_until(
        [&] { return run.session.frame_context().snapshot.settings->population.size == 9; }));
    run.ask(UndoEdit{});
    CHECK(run.frames_until(
        [&] { return run.session.frame_context().snapshot.settings->population.size == 6; }));
}

}  // namespace
}  // namespace cambrian
