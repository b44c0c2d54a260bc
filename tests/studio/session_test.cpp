#include "studio/session.h"

#include "studio_fixture.h"
#include "support/temporary_directory.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

namespace cambrian {
namespace {

ExperimentSettings small_experiment() {
    ExperimentSettings settings;
    settings.population.size = 6;
    settings.world.trial.duration = 0.5;
    settings.world.trial.settle_limit = 0.0;
    return settings;
}

class SessionRun {
public:
    SessionRun() : session({{}, small_experiment()}, test::kinds(), 2, folder.path() / "log") {}

    template <class Action>
    void ask(Action action) {
        Requests requests;
        requests.ask(std::move(action));
        session.carry_out(requests);
    }
    // Frames until something holds; gives up after many.
    bool frames_until(const std::function<bool()>& holds) {
        for (int i = 0; i < 20'000; ++i) {
            session.update(0.001 * i, 0.001);
            if (holds()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }
    std::size_t champions() const { return session.frame_context().snapshot.champions.size(); }
    std::string log() const {
        std::ostringstream text;
        text << std::ifstream(folder.path() / "log").rdbuf();
        return text.str();
    }

    TemporaryDirectory folder;
    Session session;
};

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

EditGenes lengthen_root(const FrameContext& frame, double length) {
    Genome genome = *frame.playback.exhibit().genome;
    genome.nodes[0].length = length;
    return {std::make_shared<const Genome>(genome), {"part 0 length", "old", "new"}};
}

double root_length(const SessionRun& run) {
    return run.session.frame_context().playback.exhibit().genome->nodes[0].length;
}

TEST_CASE("an edited gene is on stage at once, can be undone and made again", "[studio][session]") {
    SessionRun run;
    run.session.show_newcomer();
    const double before = root_length(run);
    run.ask(lengthen_root(run.session.frame_context(), 1.5));
    run.ask(FinishGeneEdit{});
    CHECK(run.session.frame_context().playback.phenotype().parts[0].length == 1.5);
    CHECK(run.session.frame_context().playback.exhibit().method == "edited");
    run.ask(UndoEdit{});
    CHECK(root_length(run) == before);
    CHECK(run.session.frame_context().playback.exhibit().method == "random");
    run.ask(RedoEdit{});
    CHECK(root_length(run) == 1.5);
    CHECK(run.log().find("{\"event\":\"gene edited\",\"place\":\"part 0 length\"") !=
          std::string::npos);
    CHECK(run.log().find("gene undone") != std::string::npos);
}

TEST_CASE("an edited creature is scored anew and saved as edited", "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const std::string parent = run.session.frame_context().playback.exhibit().uid;
    run.ask(lengthen_root(run.session.frame_context(), 1.1));
    run.ask(lengthen_root(run.session.frame_context(), 1.2));
    CHECK(run.session.frame_context().score == nullptr);
    REQUIRE(run.frames_until([&] { return run.session.frame_context().score != nullptr; }));
    const auto path = run.folder.path() / "edited.creature.json";
    run.ask(SaveCreatureFile{path});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    const auto saved = load_creature(path, test::kinds());
    REQUIRE(saved);
    CHECK(saved->method == "edited");
    CHECK(saved->parents == std::vector<std::string>{parent});
    CHECK(saved->genome.nodes[0].length == 1.2);
}

TEST_CASE("a gene outside its range is refused with a message", "[studio][session]") {
    SessionRun run;
    run.session.show_newcomer();
    const double before = root_length(run);
    run.ask(lengthen_root(run.session.frame_context(), 25.0));
    run.session.update(0.1, 0.0);
    CHECK(root_length(run) == before);
    REQUIRE(run.session.frame_context().notice != nullptr);
    CHECK(run.session.frame_context().notice->text.find("/nodes/0/length") != std::string::npos);
    CHECK_FALSE(run.session.frame_context().can_undo());
}

TEST_CASE("with another creature on show, undo is of the settings again", "[studio][session]") {
    SessionRun run;
    run.session.show_newcomer();
    const auto other =
        std::make_shared<const Exhibit>(run.session.frame_context().playback.exhibit());
    run.ask(lengthen_root(run.session.frame_context(), 1.5));
    ExperimentSettings moon = run.session.frame_context().editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.ask(ShowExhibit{other});
    run.ask(UndoEdit{});
    CHECK(run.session.frame_context().editor.draft().world.environment.gravity == 9.81);
}

TEST_CASE("a forced neuron marks the run as disturbed", "[studio][session]") {
    SessionRun run;
    run.ask(ForceNeuron{0, 1.0});  // nothing on show: nothing happens
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    REQUIRE_FALSE(run.session.frame_context().playback.phenotype().network.neurons.empty());
    run.ask(ForceNeuron{0, 1.0});
    CHECK(run.session.frame_context().playback.disturbed());
    run.ask(ReleaseNeuron{0});
    CHECK(run.session.frame_context().playback.forced().empty());
    run.ask(RestartPlayback{});
    CHECK_FALSE(run.session.frame_context().playback.disturbed());
}

TEST_CASE("a champion on show knows its line", "[studio][session]") {
    SessionRun run;
    for (std::size_t i = 0; i < 4; ++i) {
        run.ask(RunOneGeneration{});
        REQUIRE(run.frames_until([&] { return run.champions() == i + 1; }));
    }
    run.ask(ShowChampion{3});
    const FrameContext frame = run.session.frame_context();
    const Exhibit& exhibit = frame.playback.exhibit();
    CHECK(exhibit.experiment == frame.snapshot.experiment);
    CHECK(exhibit.mother.get() == frame.snapshot.champions[3].individual->mother.get());
}

}  // namespace
}  // namespace cambrian
