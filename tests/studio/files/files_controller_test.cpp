#include "studio/files/files_controller.h"

#include "core/files/file_io.h"
#include "evolution/evaluation/trials.h"
#include "persist/creature/creature_file.h"
#include "persist/creature/page_document.h"
#include "persist/records/statistics_csv.h"
#include "studio_fixture.h"
#include "studio_run.h"

#include <fstream>
#include <sstream>

namespace cambrian {
namespace {

using test::finish_generations;
using test::StudioRun;

TEST_CASE("statistics are exported as a table with a row a generation", "[studio][files]") {
    StudioRun run;
    const auto path = run.folder.path() / "run.csv";
    run.ask(OpenFilePanel{FileTask::kSaveStatistics});
    CHECK_FALSE(run.studio.frame_context().files.browser.open);  // there is nothing to export yet
    finish_generations(run, 3);
    run.ask(OpenFilePanel{FileTask::kSaveStatistics});
    CHECK(run.studio.frame_context().files.browser.open);
    run.ask(SaveStatisticsFile{path});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    CHECK(text.str() == statistics_csv(run.studio.frame_context().experiment.snapshot.history));
}

TEST_CASE("a plot is requested from the window in the chosen size", "[studio][files]") {
    StudioRun run;
    finish_generations(run, 1);
    run.ask(OpenFilePanel{FileTask::kSavePlot, {1920, 1080}});
    CHECK(run.studio.frame_context().files.browser.picture.width == 1920);
    CHECK(run.studio.frame_context().files.browser.suggested_name == "fitness.png");
    run.ask(SavePlotPicture{"plot.png", {1920, 1080}});
    const auto request = run.studio.files().take_orders().plot;
    REQUIRE(request);
    CHECK(request->size.height == 1080);
    CHECK_FALSE(run.studio.files().take_orders().plot);
}

TEST_CASE("a clip of the creature on display is written while other files are", "[studio][files]") {
    StudioRun run;
    finish_generations(run, 1);
    const auto gif = run.folder.path() / "a.gif";
    const auto settings = run.folder.path() / "a.toml";
    const ClipKind& kind = *clip_kind_of("a.gif");
    run.ask(SaveClip{gif, {kind.format, kind.card, 320, 180, 86400.0, 0.25}});
    CHECK(run.studio.frame_context().files.writing.name == "a.gif");
    run.ask(SaveSettingsFile{settings});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(settings); }));
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(gif); }));
    REQUIRE(
        run.frames_until([&] { return run.studio.frame_context().files.writing.name.empty(); }));
    CHECK_THAT(run.log(), Catch::Contains("a.gif"));
}

TEST_CASE("a page of the creature on display and one of the run are saved", "[studio][files]") {
    StudioRun run;
    run.studio.files().use_page_parts({.version = "1",
                                       .folder = CAMBRIAN_SOURCE_DIR "/assets/page",
                                       .engine = {},
                                       .licences = {}});
    const auto one = run.folder.path() / "one.html";
    const auto all = run.folder.path() / "all.html";
    finish_generations(run, 2);
    run.ask(SaveRunPage{all});
    const auto notice = [&] { return run.studio.frame_context().window.notice; };
    REQUIRE(run.frames_until([&] { return notice() && notice()->kind == NoticeKind::kProblem; }));
    CHECK_THAT(notice()->text, Catch::Contains("no file yet"));
    CHECK_FALSE(std::filesystem::exists(all));
    run.ask(SaveExperimentFile{run.folder.path() / "run.cambrian"});
    REQUIRE(run.frames_until([&] { return run.studio.files().saves() == 1; }));
    run.ask(SaveRunPage{all});
    run.ask(SaveCreatureFile{one});
    REQUIRE(run.frames_until([&] { return run.studio.files().saves() == 3; }));
    const auto shown = load_creature(one, test::kinds());
    REQUIRE(shown);
    CHECK(*shown->creature.individual->genome == *test::shown_in(run).genome());
    const std::string page = read_file(all, kMaxPageBytes).value();
    for (const char* part : {"generation 1", "\"rows\"", "Champions of ", "cambrian-creature-2"})
        CHECK_THAT(page, Catch::Contains(part));
}

TEST_CASE("a film of the run and a race of the starred are saved", "[studio][files]") {
    StudioRun run;
    const ClipChoice choice{clip_kind_of("a.gif")->format, false, 96, 54, 0.2, 1.0};
    finish_generations(run, 2);
    run.ask(SaveExperimentFile{run.folder.path() / "run.cambrian"});
    REQUIRE(run.frames_until([&] { return run.studio.files().saves() == 1; }));
    run.ask(SaveFilm{run.folder.path() / "film.gif", choice});
    REQUIRE(run.frames_until([&] { return run.studio.files().saves() == 2; }));
    const auto& population = run.studio.frame_context().experiment.snapshot.population;
    const auto star = [&](std::size_t place) {
        const auto& snapshot = run.studio.frame_context().experiment.snapshot;
        run.ask(ToggleStar{{1, population[place], snapshot.settings}});
    };
    star(0);
    run.ask(SaveRace{run.folder.path() / "race.gif", choice});
    CHECK_THAT(run.studio.frame_context().window.notice->text, Catch::Contains("2 to 6"));
    star(1);
    run.ask(SaveRace{run.folder.path() / "race.gif", choice});
    REQUIRE(run.frames_until([&] { return run.studio.files().saves() == 3; }));
    for (const char* name : {"film.gif", "race.gif"})
        CHECK(read_file(run.folder.path() / name, 1'000'000).value().starts_with("GIF89a"));
}

TEST_CASE("a clip that is stopped leaves nothing", "[studio][files]") {
    StudioRun run;
    finish_generations(run, 1);
    const auto folder = run.folder.path() / "clips";
    std::filesystem::create_directory(folder);
    const ClipKind& kind = *clip_kind_of("a.card.png");
    for (const char* name : {"a.card.png", "b.card.png"})
        run.ask(SaveClip{folder / name, {kind.format, true, 960, 1280, 86400.0, 0.01}});
    run.ask(StopFile{});
    REQUIRE(run.frames_until(
        [&] { return run.studio.frame_context().files.writing.name == "b.card.png"; }));
    run.ask(StopFile{});
    REQUIRE(
        run.frames_until([&] { return run.studio.frame_context().files.writing.name.empty(); }));
    CHECK(std::filesystem::is_empty(folder));
    CHECK(run.studio.frame_context().window.notice->text == "b.card.png was not saved.");
}

TEST_CASE("a clip that cannot be written is told", "[studio][files]") {
    StudioRun run;
    finish_generations(run, 1);
    const ClipKind& kind = *clip_kind_of("a.gif");
    run.ask(SaveClip{run.folder.path() / "nowhere" / "a.gif",
                     {kind.format, false, 320, 180, 0.1, 1.0}});
    REQUIRE(run.frames_until([&] {
        const Notice* notice = run.studio.frame_context().window.notice;
        return notice != nullptr && notice->kind == NoticeKind::kProblem;
    }));
    CHECK_THAT(run.studio.frame_context().window.notice->text, Catch::Contains("nowhere/a.gif"));
}

TEST_CASE("what was seen becomes a clip", "[studio][files]") {
    StudioRun run;
    const auto path = run.folder.path() / "seen.gif";
    PicturePacker packer;
    SeenClip seen{64, 48, 3.0, {}};
    for (int i = 0; i < 10; ++i) {
        const auto level = static_cast<std::uint8_t>(20 * i);
        const Image picture{64, 48, std::vector<std::uint8_t>(3 * 64 * 48, level)};
        seen.pictures.push_back({1.0 + 0.2 * i, packer.pack(picture)});
    }
    run.studio.files().save_seen(path, seen);
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    std::ostringstream bytes;
    bytes << std::ifstream(path).rdbuf();
    const std::string gif = bytes.str();
    CHECK(gif.starts_with("GIF89a"));
    int controls = 0;
    for (std::size_t at = 0; (at = gif.find("\x21\xf9\x04", at)) != std::string::npos; ++at)
        ++controls;
    CHECK(controls == 40);  // two seconds at the usual rate
}

TEST_CASE("a sample moves as long as it is watched", "[studio][files][samples]") {
    StudioRun run;
    const auto path = run.folder.path() / "crawler.creature.json";
    const CreatureDocument document{unjudged(test::crawler(test::kinds().creature.catalog))};
    REQUIRE(save_creature(path, document, test::kinds()));
    run.studio.files().use_samples({run.folder.path()});
    run.ask(ToggleSamples{});
    const auto library = [&]() -> const SampleLibrary& {
        return *run.studio.frame_context().files.samples;
    };
    REQUIRE(run.frames_until([&] { return library().read; }));
    CHECK(library().motion == nullptr);
    run.ask(WatchSample{path});
    CHECK(library().watched == path);
    REQUIRE(run.frames_until(
        [&] { return library().motion != nullptr && library().motion->time() > 0.5; }));
    CHECK(library().motion->cell(0).frames.size() > 30);
    CHECK(run.studio.animating());
    run.ask(WatchSample{});
    CHECK(library().motion == nullptr);
    run.ask(WatchSample{run.folder.path() / "missing.creature.json"});
    CHECK(library().motion == nullptr);
}

TEST_CASE("a saved creature loads as the same creature", "[studio][files]") {
    StudioRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const GenomePtr genome = run.studio.frame_context().viewer.playback.exhibit().genome();
    const auto path = run.folder.path() / "best.creature.json";
    run.ask(SaveCreatureFile{path});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] {
        return run.studio.frame_context().viewer.playback.exhibit().source == ExhibitSource::kFile;
    }));
    CHECK(*run.studio.frame_context().viewer.playback.exhibit().genome() == *genome);
}

TEST_CASE(
    "a creature without a score is loaded with the world of its file, or else of the experiment",
    "[studio][files]") {
    StudioRun run;
    const auto shown = [&](const std::string& name, double gravity) {
        Genome genome = *test::crawler(test::kinds().creature.catalog);
        genome.name = name;
        ExperimentSettings settings;
        settings.world.environment.gravity = gravity;
        const CreatureDocument document{
            unjudged(std::make_shared<const Genome>(genome),
                     std::make_shared<const ExperimentSettings>(settings))};
        const auto path = run.folder.path() / "some.creature.json";
        REQUIRE(save_creature(path, document, test::kinds()));
        run.ask(LoadFile{path});
        const Playback& playback = run.studio.frame_context().viewer.playback;
        REQUIRE(run.frames_until([&] { return playback.exhibit().title == name; }));
        return playback.exhibit().settings();
    };
    const ExperimentSettings& draft = run.studio.frame_context().experiment.editor.draft();
    CHECK(shown("on the moon", 1.62).world.environment.gravity == 1.62);
    CHECK(same_judgement(shown("anywhere", Environment{}.gravity), draft));
}

TEST_CASE("a creature scored by several trials is verified by as many, tick by tick",
          "[studio][files]") {
    StudioRun run;
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
    CreatureDocument document =
        creature_document({.individual = std::make_shared<const Individual>(judged),
                           .settings = std::make_shared<const ExperimentSettings>(settings)},
                          test::kinds());
    complete_score(document, test::kinds());
    const auto path = run.folder.path() / "robust.creature.json";
    REQUIRE(save_creature(path, document, test::kinds()));
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().viewer.score != nullptr; }));
    const FrameContext frame = run.studio.frame_context();
    CHECK(frame.viewer.score->digest == judged.result.digest);
    CHECK(frame.viewer.score->digest != frame.viewer.score->record.digest);
    CHECK_FALSE(first_different_tick(frame.viewer.score->ticks, document.notes.ticks));

    const auto copy = run.folder.path() / "copy.creature.json";
    run.ask(SaveCreatureFile{copy});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(copy); }));
    const auto copied = load_creature(copy, test::kinds());
    REQUIRE(copied);
    CHECK(copied->ancestry == document.ancestry);
    CHECK(same_score(*copied, document));
}

TEST_CASE("loading a creature reports its kinds that the experiment has not enabled",
          "[studio][files]") {
    StudioRun run;
    run.ask(LoadFile{std::string(CAMBRIAN_SOURCE_DIR) +
                     "/tests/persist/creatures/W04_linear_joint.creature.json"});
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().window.notice != nullptr; }));
    CHECK_THAT(run.studio.frame_context().window.notice->text,
               Catch::Contains("\"linear\"") && !Catch::Contains(" W04 "));
}

TEST_CASE("a creature saved as a card is drawn by the window and can be loaded",
          "[studio][files]") {
    StudioRun run;
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    const GenomePtr genome = run.studio.frame_context().viewer.playback.exhibit().genome();
    const auto path = run.folder.path() / "best.card.png";
    run.ask(SaveCreatureFile{path});
    std::optional<PreparedCard> card;
    REQUIRE(run.frames_until([&] {
        if (!card) card = run.studio.files().take_orders().card;
        return card.has_value();
    }));
    CHECK(card->subject.generation == 0);
    CHECK(card->subject.verified == true);
    CHECK_FALSE(std::filesystem::exists(path));
    run.studio.files().save_card(*card, {2, 2, std::vector<std::uint8_t>(12, 128)});
    REQUIRE(run.frames_until([&] { return std::filesystem::exists(path); }));
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] {
        return run.studio.frame_context().viewer.playback.exhibit().source == ExhibitSource::kFile;
    }));
    CHECK(*run.studio.frame_context().viewer.playback.exhibit().genome() == *genome);
}

TEST_CASE("a file that cannot be opened is a notice and changes nothing", "[studio][files]") {
    StudioRun run;
    const auto path = run.folder.path() / "broken.creature.json";
    std::ofstream(path) << "{ not json";
    run.ask(LoadFile{path});
    REQUIRE(run.frames_until([&] { return run.studio.frame_context().window.notice != nullptr; }));
    const Notice& notice = *run.studio.frame_context().window.notice;
    CHECK(notice.kind == NoticeKind::kProblem);
    CHECK(notice.text.find("broken.creature.json") != std::string::npos);
    CHECK(run.studio.frame_context().viewer.playback.empty());
}

TEST_CASE("a card's generation is the one of its title", "[studio][files]") {
    StudioRun run;
    const auto survivor = [&]() -> const JudgedIndividual* {
        for (const JudgedIndividual& each :
             run.studio.frame_context().experiment.snapshot.champions) {
            if (each.individual->born < each.generation) return &each;
        }
        return nullptr;
    };
    for (std::size_t count = 1; count <= 20 && survivor() == nullptr; ++count)
        finish_generations(run, count);
    REQUIRE(survivor() != nullptr);
    const std::uint32_t generation = survivor()->generation;
    run.ask(ShowChampion{generation});
    run.ask(SaveCreatureFile{run.folder.path() / "old.card.png"});
    std::optional<PreparedCard> card;
    REQUIRE(run.frames_until([&] {
        if (!card) card = run.studio.files().take_orders().card;
        return card.has_value();
    }));
    CHECK(card->subject.generation == generation);
}

}  // namespace
}  // namespace cambrian
