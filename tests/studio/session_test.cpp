#include "evolution/trials.h"
#include "persist/statistics_csv.h"
#include "session_run.h"
#include "studio_fixture.h"

#include <algorithm>
#include <fstream>

namespace cambrian {
namespace {

using test::SessionRun;

TEST_CASE("the tour is offered until it was taken or declined", "[studio][session]") {
    SessionRun run;
    run.session.guide().offer_tour();
    CHECK(run.session.frame_context().guide.tour_step == 0);
    run.ask(TurnTour{1});
    CHECK(run.session.frame_context().guide.tour_step == 1);
    run.ask(TurnTour{-1});
    CHECK(run.session.frame_context().guide.tour_step == -1);
    CHECK(run.session.view().tour_taken);
    run.session.guide().offer_tour();
    CHECK(run.session.frame_context().guide.tour_step == -1);
    run.ask(TurnTour{0});  // from the Help menu, at any time
    CHECK(run.session.frame_context().guide.tour_step == 0);
}

TEST_CASE("help and samples come from the assets", "[studio][session]") {
    SessionRun run;
    run.session.use_assets(std::string(CAMBRIAN_SOURCE_DIR) + "/assets");
    REQUIRE(
        run.frames_until([&] { return !run.session.frame_context().guide.help->pages.empty(); }));
    run.ask(ShowHelp{"viewport"});
    CHECK(run.session.frame_context().guide.help_shown);
    CHECK(run.session.frame_context().guide.help->open == "viewport");
    run.ask(ToggleSamples{});
    REQUIRE(run.frames_until([&] { return run.session.frame_context().files.samples->read; }));
    CHECK_FALSE(run.session.frame_context().files.samples->samples.empty());
}

TEST_CASE("finding a setting brings the settings back into the window", "[studio][session]") {
    SessionRun run;
    ViewState hidden = run.session.view();
    hidden.panels.left = false;
    run.ask(ChangeView{hidden});
    run.ask(FindSetting{});
    CHECK(run.session.view().panels.left);
    CHECK(run.session.frame_context().experiment.find_asked == 1);
}

TEST_CASE("a new run can begin with the creature on show", "[studio][session]") {
    SessionRun run;
    run.ask(StartFromShown{});  // nothing on show: nothing happens
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const GenomePtr shown = run.session.frame_context().viewer.playback.exhibit().genome;
    run.ask(StartFromShown{});
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] {
        const EvolutionSnapshot& snapshot = run.session.frame_context().experiment.snapshot;
        return snapshot.experiment == 2 && snapshot.champions.size() == 1;
    }));
    const auto& population = run.session.frame_context().experiment.snapshot.population;
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
    REQUIRE_FALSE(frame.viewer.playback.empty());
    CHECK(frame.viewer.playback.exhibit().genome ==
          frame.experiment.snapshot.champions[0].individual->genome);
    CHECK(run.log().find("{\"event\":\"generation\",\"number\":0,\"best\":") != std::string::npos);
}

// Runs until so many generations are finished.
void finish_generations(SessionRun& run, std::size_t count) {
    while (run.champions() < count) {
        const std::size_t before = run.champions();
        run.ask(RunOneGeneration{});
        REQUIRE(run.frames_until([&] { return run.champions() == before + 1; }));
        REQUIRE(run.frames_until([&] {
            return run.session.frame_context().experiment.snapshot.status == EngineStatus::kPaused;
        }));
    }
}

const Exhibit& shown_in(const SessionRun& run) {
    return run.session.frame_context().viewer.playback.exhibit();
}

TEST_CASE("scrubbing shows past champions until the newest is asked for", "[studio][session]") {
    SessionRun run;
    run.ask(ShowChampion{0});  // there is none yet: nothing happens
    CHECK(run.session.frame_context().viewer.playback.empty());
    finish_generations(run, 4);
    for (const std::uint32_t generation : {2U, 1U, 0U, 3U, 0U}) {
        run.ask(ShowChampion{generation});
        CHECK(shown_in(run).generation == generation);
        CHECK(shown_in(run).genome == run.session.frame_context()
                                          .experiment.snapshot.champions[generation]
                                          .individual->genome);
    }
    run.ask(ShowChampion{77});
    CHECK(shown_in(run).generation == 0);
    finish_generations(run, 5);
    run.ask(ShowChampion{1});
    run.ask(ShowNewest{});
    CHECK(shown_in(run).generation == 4);
    CHECK(run.session.view().newest_champion);
}

TEST_CASE("after a fast scrub the creature that stayed gets its score", "[studio][session]") {
    SessionRun run;
    finish_generations(run, 3);
    for (int i = 0; i < 200; ++i)
        run.ask(ShowChampion{static_cast<std::uint32_t>(i % 3)});
    REQUIRE(run.frames_until([&] { return run.session.frame_context().viewer.score != nullptr; }));
    CHECK(run.session.frame_context().viewer.score->record.digest == shown_in(run).result->digest);
}

TEST_CASE("statistics are exported as a table with a row a generation", "[studio][session]") {
    SessionRun run;
    const auto path = run.folder.path() / "run.csv";
    run.ask(OpenFilePanel{FileTask::kSaveStatistics});
    CHECK_FALSE(run.session.frame_context().files.browser.open);  // nothing to export yet
    finish_generations(run, 3);
    run.ask(OpenFilePanel{FileTask::kSaveStatistics});
    CHECK(run.session.frame_context().files.browser.open);
    run.ask(SaveStatisticsFile{path});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    CHECK(text.str() == statistics_csv(run.session.frame_context().experiment.snapshot.history));
}

TEST_CASE("a plot is asked of the window in the size that was chosen", "[studio][session]") {
    SessionRun run;
    finish_generations(run, 1);
    run.ask(OpenFilePanel{FileTask::kSavePlot, {1920, 1080}});
    CHECK(run.session.frame_context().files.browser.picture.width == 1920);
    CHECK(run.session.frame_context().files.browser.suggested_name == "fitness.png");
    run.ask(SavePlotPicture{"plot.png", {1920, 1080}});
    const auto request = run.session.files().take_orders().plot;
    REQUIRE(request);
    CHECK(request->size.height == 1080);
    CHECK_FALSE(run.session.files().take_orders().plot);
}

TEST_CASE("the creature on show can have a star and is shown from it under its own settings",
          "[studio][session]") {
    SessionRun run;
    run.session.show_newcomer();
    run.ask(ToggleStarOfShown{});  // not of this experiment
    CHECK(run.session.frame_context().generations.stars.all().empty());
    finish_generations(run, 1);
    run.ask(ShowNewest{});
    run.ask(ToggleStarOfShown{});
    REQUIRE(run.session.frame_context().generations.stars.all().size() == 1);
    const ChampionRecord kept = run.session.frame_context().generations.stars.all().front();
    ExperimentSettings moon = run.session.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.ask(FinishEdit{});
    finish_generations(run, 3);
    run.ask(ShowIndividual{kept});
    CHECK(shown_in(run).genome == kept.individual->genome);
    CHECK(shown_in(run).generation == 0);
    CHECK(shown_in(run).world.environment.gravity == 9.81);
    run.ask(ToggleStarOfShown{});
    CHECK(run.session.frame_context().generations.stars.all().empty());
    run.ask(RestoreStar{});
    CHECK(run.session.frame_context().generations.stars.all().size() == 1);
}

TEST_CASE("the score shown is the one the engine found, and the replay is verified",
          "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.session.frame_context().viewer.score != nullptr; }));
    const FrameContext frame = run.session.frame_context();
    const EvaluationResult& result = *frame.viewer.playback.exhibit().result;
    CHECK(frame.viewer.score->score.value == result.fitness);
    CHECK(frame.viewer.score->record.digest == result.digest);
}

TEST_CASE("a saved creature loads as the same creature", "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const GenomePtr genome = run.session.frame_context().viewer.playback.exhibit().genome;
    const auto path = run.folder.path() / "best.creature.json";
    run.ask(SaveCreatureFile{path});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] {
        return run.session.frame_context().viewer.playback.exhibit().source == ExhibitSource::kFile;
    }));
    CHECK(*run.session.frame_context().viewer.playback.exhibit().genome == *genome);
}

TEST_CASE("a creature judged by several trials is verified by as many, tick by tick",
          "[studio][session]") {
    SessionRun run;
    ExperimentSettings settings = test::small_experiment();
    settings.world.trial.trials = 3;
    settings.world.trial.friction_jitter = 0.2;
    Individual judged;
    judged.uid = 77;
    judged.method = "imported";
    judged.genome = test::crawler(test::kinds().creature.catalog);
    judged.result = evaluate_in_trials(
        {.genome = judged.genome, .trial_seed = trial_seed(settings)}, settings, test::kinds());
    judged.evaluated = true;
    CreatureDocument document = creature_document(judged, settings, test::kinds());
    complete_score(document, test::kinds());
    const auto path = run.folder.path() / "robust.creature.json";
    REQUIRE(save_creature(path, document, test::kinds()));
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] { return run.session.frame_context().viewer.score != nullptr; }));
    const FrameContext frame = run.session.frame_context();
    CHECK(frame.viewer.score->digest == judged.result.digest);
    CHECK(frame.viewer.score->digest != frame.viewer.score->record.digest);
    CHECK_FALSE(first_different_tick(frame.viewer.score->ticks, document.scored->ticks));

    const auto copy = run.folder.path() / "copy.creature.json";
    run.ask(SaveCreatureFile{copy});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(copy); }));
    const auto copied = load_creature(copy, test::kinds());
    REQUIRE(copied);
    CHECK(copied->ancestry == document.ancestry);
    CHECK(copied->scored == document.scored);
}

TEST_CASE("what a loaded creature uses that the experiment has not enabled is told",
          "[studio][session]") {
    SessionRun run;
    run.ask(LoadFile{std::string(CAMBRIAN_SOURCE_DIR) +
                     "/tests/persist/creatures/W04_linear_joint.creature.json"});
    REQUIRE(run.frames_until([&] { return run.session.frame_context().window.notice != nullptr; }));
    CHECK_THAT(run.session.frame_context().window.notice->text, Catch::Contains("W04 "));
}

TEST_CASE("a creature saved as a card is prepared, drawn by the window and comes back",
          "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const GenomePtr genome = run.session.frame_context().viewer.playback.exhibit().genome;
    const auto path = run.folder.path() / "best.card.png";
    run.ask(SaveCreatureFile{path});
    std::optional<PreparedCard> card;
    REQUIRE(run.frames_until([&] {
        if (!card) card = run.session.files().take_orders().card;
        return card.has_value();
    }));
    CHECK(card->subject.generation == 0);
    CHECK(card->subject.verified == true);
    CHECK_FALSE(std::filesystem::exists(path));
    run.session.files().save_card(*card, {2, 2, std::vector<std::uint8_t>(12, 128)});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] {
        return run.session.frame_context().viewer.playback.exhibit().source == ExhibitSource::kFile;
    }));
    CHECK(*run.session.frame_context().viewer.playback.exhibit().genome == *genome);
}

TEST_CASE("a file that cannot be opened is a notice and changes nothing", "[studio][session]") {
    SessionRun run;
    const auto path = run.folder.path() / "broken.creature.json";
    std::ofstream(path) << "{ not json";
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] { return run.session.frame_context().window.notice != nullptr; }));
    const Notice& notice = *run.session.frame_context().window.notice;
    CHECK(notice.kind == NoticeKind::kProblem);
    CHECK(notice.text.find("broken.creature.json") != std::string::npos);
    CHECK(run.session.frame_context().viewer.playback.empty());
}

TEST_CASE("an edited world is felt on stage at once and by the engine once let go",
          "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    ExperimentSettings moon = run.session.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    CHECK(run.session.frame_context().viewer.playback.environment().gravity == 1.62);
    CHECK(run.session.frame_context().experiment.snapshot.settings->world.environment.gravity ==
          9.81);
    run.ask(FinishEdit{});
    CHECK(run.frames_until([&] {
        return run.session.frame_context()
                   .experiment.snapshot.settings->world.environment.gravity == 1.62;
    }));
    CHECK(run.session.frame_context().experiment.snapshot.journal.size() == 2);
}

TEST_CASE("an edit of anything but the world leaves the stage's world alone", "[studio][session]") {
    SessionRun run;
    run.session.show_newcomer();
    ExperimentSettings moon = run.session.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.ask(FinishEdit{});
    run.session.show_newcomer();
    const Environment before = run.session.frame_context().viewer.playback.environment();
    ExperimentSettings larger = run.session.frame_context().experiment.editor.draft();
    larger.population.size = 12;
    run.ask(EditSettings{larger, "population.size"});
    run.ask(FinishEdit{});
    CHECK(run.session.frame_context().viewer.playback.environment() == before);
    CHECK(before.gravity == 1.62);
}

TEST_CASE("a new run from the present creatures begins with them", "[studio][session]") {
    SessionRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const auto experiment = run.session.frame_context().experiment.snapshot.experiment;
    run.ask(StartNewRun{true});
    REQUIRE(run.frames_until([&] {
        return run.session.frame_context().experiment.snapshot.experiment == experiment + 1;
    }));
    CHECK(run.session.frame_context().experiment.snapshot.generation == 0);
    CHECK(run.champions() == 0);
}

TEST_CASE("undo takes an edit back from the engine too", "[studio][session]") {
    SessionRun run;
    ExperimentSettings edited = run.session.frame_context().experiment.editor.draft();
    edited.population.size = 9;
    run.ask(EditSettings{edited, "population.size"});
    run.ask(FinishEdit{});
    REQUIRE(run.frames_until([&] {
        return run.session.frame_context().experiment.snapshot.settings->population.size == 9;
    }));
    run.ask(UndoEdit{});
    CHECK(run.frames_until([&] {
        return run.session.frame_context().experiment.snapshot.settings->population.size == 6;
    }));
}

EditGenes lengthen_root(const FrameContext& frame, double length) {
    Genome genome = *frame.viewer.playback.exhibit().genome;
    genome.nodes[0].length = length;
    return {std::make_shared<const Genome>(genome), {"part 0 length", "old", "new"}};
}

double root_length(const SessionRun& run) {
    return run.session.frame_context().viewer.playback.exhibit().genome->nodes[0].length;
}

TEST_CASE("an edited gene is on stage at once, can be undone and made again", "[studio][session]") {
    SessionRun run;
    run.session.show_newcomer();
    const double before = root_length(run);
    run.ask(lengthen_root(run.session.frame_context(), 1.5));
    run.ask(FinishGeneEdit{});
    CHECK(run.session.frame_context().viewer.playback.phenotype().parts[0].length == 1.5);
    CHECK(run.session.frame_context().viewer.playback.exhibit().method == "edited");
    run.ask(UndoEdit{});
    CHECK(root_length(run) == before);
    CHECK(run.session.frame_context().viewer.playback.exhibit().method == "random");
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
    const std::string parent = run.session.frame_context().viewer.playback.exhibit().uid;
    run.ask(lengthen_root(run.session.frame_context(), 1.1));
    run.ask(lengthen_root(run.session.frame_context(), 1.2));
    CHECK(run.session.frame_context().viewer.score == nullptr);
    REQUIRE(run.frames_until([&] { return run.session.frame_context().viewer.score != nullptr; }));
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
    REQUIRE(run.session.frame_context().window.notice != nullptr);
    CHECK(run.session.frame_context().window.notice->text.find("/nodes/0/length") !=
          std::string::npos);
    CHECK_FALSE(run.session.frame_context().can_undo());
}

TEST_CASE("with another creature on show, undo is of the settings again", "[studio][session]") {
    SessionRun run;
    run.session.show_newcomer();
    const auto other =
        std::make_shared<const Exhibit>(run.session.frame_context().viewer.playback.exhibit());
    run.ask(lengthen_root(run.session.frame_context(), 1.5));
    ExperimentSettings moon = run.session.frame_context().experiment.editor.draft();
    moon.world.environment.gravity = 1.62;
    run.ask(EditSettings{moon, "environment.gravity"});
    run.ask(ShowExhibit{other});
    run.ask(UndoEdit{});
    CHECK(run.session.frame_context().experiment.editor.draft().world.environment.gravity == 9.81);
}

TEST_CASE("a forced neuron marks the run as disturbed", "[studio][session]") {
    SessionRun run;
    run.ask(ForceNeuron{0, 1.0});  // nothing on show: nothing happens
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    REQUIRE_FALSE(run.session.frame_context().viewer.playback.phenotype().network.neurons.empty());
    run.ask(ForceNeuron{0, 1.0});
    CHECK(run.session.frame_context().viewer.playback.disturbed());
    run.ask(ReleaseNeuron{0});
    CHECK(run.session.frame_context().viewer.playback.forced().empty());
    run.ask(RestartPlayback{});
    CHECK_FALSE(run.session.frame_context().viewer.playback.disturbed());
}

TEST_CASE("a champion on show knows its line", "[studio][session]") {
    SessionRun run;
    for (std::size_t i = 0; i < 4; ++i) {
        run.ask(RunOneGeneration{});
        REQUIRE(run.frames_until([&] { return run.champions() == i + 1; }));
    }
    run.ask(ShowChampion{3});
    const FrameContext frame = run.session.frame_context();
    const Exhibit& exhibit = frame.viewer.playback.exhibit();
    CHECK(exhibit.experiment == frame.experiment.snapshot.experiment);
    CHECK(exhibit.mother.get() == frame.experiment.snapshot.champions[3].individual->mother.get());
}

}  // namespace
}  // namespace cambrian
