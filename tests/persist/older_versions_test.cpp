// Reads files of each earlier version of the formats, from tests/persist/versions/VERSION/.

#include "core/files/file_io.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/creature_file.h"
#include "persist/creature/creature_format.h"
#include "persist/creature/rescoring.h"
#include "persist/experiment/experiment_file.h"
#include "persist/preserve/preserve_file.h"
#include "persist/preserve/preserve_tables.h"
#include "persist/records/experiment_schema.h"
#include "persist/settings/settings_file.h"
#include "persist/steered_run.h"
#include "simulator/simulator_version.h"
#include "support/temporary_directory.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

const std::filesystem::path kVersions = CAMBRIAN_SOURCE_DIR "/tests/persist/versions";
constexpr std::size_t kLargest = 1'000'000;

std::string bytes_of(const std::filesystem::path& path) {
    const auto bytes = read_file(path, kLargest);
    REQUIRE(bytes);
    return *bytes;
}

std::int64_t version_in(const std::filesystem::path& path) {
    return Database(path, Database::Access::kRead).integer("PRAGMA user_version");
}

// Checks the contents of every version's run.cambrian: four generations of eight creatures, with
// commands in the third, two grids, a star and a shelf with one creature.
void check_run(const SavedExperiment& saved) {
    REQUIRE(saved.latest);
    CHECK(saved.latest->generation == 3);
    CHECK(saved.latest->population.size() == 8);
    CHECK(saved.journal.size() == 3);
    CHECK(setting_changes(saved).size() == 2);
    CHECK(saved.latest->settings->world.environment.gravity == 3.71);
    REQUIRE(saved.simulators.size() == 1);
    CHECK(saved.simulators.front().version == "1.0");
}

}  // namespace

TEST_CASE("an experiment of any version is read without a change", "[persist][older_versions]") {
    const std::string version = GENERATE("1");
    const TemporaryDirectory folder;
    const auto path = folder / "run.cambrian";
    std::filesystem::copy(kVersions / version / "run.cambrian", path);
    const std::string before = bytes_of(path);
    const auto saved = load_experiment(path, kinds());
    INFO((saved ? "" : saved.error().message));
    REQUIRE(saved);
    check_run(*saved);
    CHECK(bytes_of(path) == before);
}

TEST_CASE("an experiment of any version goes on with this simulator", "[persist][older_versions]") {
    const std::string version = GENERATE("1");
    const TemporaryDirectory folder;
    const auto path = folder / "run.cambrian";
    std::filesystem::copy(kVersions / version / "run.cambrian", path);
    auto opened = open_experiment(path, kinds());
    INFO((opened ? "" : opened.error().message));
    REQUIRE(opened);
    check_run(opened->saved);
    CHECK(opened->stars.size() == 1);
    CHECK(opened->picking.shelf.size() == 1);
    CHECK(opened->picking.tree.size() == 2);
    CHECK(opened->picking.picks == std::vector<std::size_t>{3});
    CHECK(version_in(path) == kExperimentVersion);
    Evolution evolution = resumed(opened->saved, kinds());
    run_on(evolution, *opened->file, 6);
    opened->file.reset();
    const auto again = load_experiment(path, kinds());
    REQUIRE(again);
    CHECK(again->digests.size() == 6);
    CHECK(again->simulators.size() == 2);
    CHECK(again->simulators.back().generation == 4);
    CHECK(again->simulators.back().version == kSimulatorVersion);
}

TEST_CASE("lines and body plans that an older version did not tell are filled in",
          "[persist][older_versions]") {
    const TemporaryDirectory folder;
    std::filesystem::copy(kVersions / "1" / "run.cambrian", folder / "run.cambrian");
    const auto saved = load_experiment(folder / "run.cambrian", kinds());
    REQUIRE(saved);
    for (IndividualPtr one : saved->latest->population) {
        CHECK(one->result.plan == hashes_of(*one->genome, *saved->latest->settings, kinds()).plan);
        CHECK(one->result.scores.empty());
        const std::uint64_t line = one->line;
        while (one->mother.get())
            one = one->mother.get();
        CHECK(line == one->line);
        CHECK(line == (one->parents[0] == 0 ? one->uid : one->parents[0]));
    }
    for (const GenerationStatistics& generation : saved->latest->history)
        CHECK(generation.best_lowest == generation.best);
}

TEST_CASE("an experiment of an older version goes on with the breeding and founders of then",
          "[persist][older_versions]") {
    const TemporaryDirectory folder;
    std::filesystem::copy(kVersions / "1" / "run.cambrian", folder / "run.cambrian");
    const auto saved = load_experiment(folder / "run.cambrian", kinds());
    REQUIRE(saved);
    CHECK(saved->latest->settings->population.tuned == 0.0);
    CHECK(saved->latest->settings->founders.rhythmic_share == 0.0);
    CHECK(saved->latest->settings->population.size == 8);
}

TEST_CASE("an experiment tells scores of another simulator until everyone was judged again",
          "[persist][older_versions]") {
    const std::string current(kSimulatorVersion);
    auto saved = load_experiment(kVersions / "1" / "run.cambrian", kinds());
    REQUIRE(saved);
    saved->simulators = {{0, current}};
    CHECK_FALSE(other_simulator(*saved));
    saved->simulators = {{0, "0.9"}};
    const std::string words = "scored by simulator 0.9, this is " + current;
    CHECK(other_simulator(*saved) == words);
    // When this version continues the run, survivors keep their scores.
    saved->simulators = {{0, "0.9"}, {3, current}};
    CHECK(other_simulator(*saved) == words);
    saved->journal.push_back({3, RescorePopulation{}});
    CHECK_FALSE(other_simulator(*saved));
    saved->journal.back() = {3, AddImmigrants{}};
    ExperimentSettings moon = *saved->latest->settings;
    moon.world.environment.gravity = 1.62;
    saved->journal.push_back({3, ChangeSettings{std::make_shared<const ExperimentSettings>(moon)}});
    CHECK_FALSE(other_simulator(*saved));
    saved->simulators = {{0, current}, {3, "0.9"}};
    CHECK(other_simulator(*saved) == words);
}

TEST_CASE("an older experiment that is damaged stays as it was", "[persist][older_versions]") {
    const auto [sql, words] = GENERATE(table<std::string, std::string>({
        {"DROP TABLE novel", "table \"novel\" is missing"},
        {"CREATE TABLE simulators (a)", "simulators"},
        {"DELETE FROM results", "its score is missing"},
    }));
    const TemporaryDirectory folder;
    const auto path = folder / "run.cambrian";
    std::filesystem::copy(kVersions / "1" / "run.cambrian", path);
    Database(path, Database::Access::kWrite).execute(sql);
    const auto opened = open_experiment(path, kinds());
    REQUIRE_FALSE(opened);
    CHECK_THAT(opened.error().message, Catch::Contains(words));
    CHECK(version_in(path) == 1);
}

TEST_CASE("a creature of any version is loaded and moves as its simulator had it",
          "[persist][older_versions]") {
    const std::string version = GENERATE("1", "older_simulator");
    const auto document = load_creature(kVersions / version / "walker.creature.json", kinds());
    REQUIRE(document);
    CHECK(document->warnings.empty());
    REQUIRE(document->scored());
    const EvaluationResult result = run_scored_trial(*document, kinds());
    const bool same =
        result.digest == document->result().digest && result.fitness == document->score();
    CHECK(same == (document->notes.simulator == kSimulatorVersion));
    CHECK(same != other_simulator(*document).has_value());
}

TEST_CASE("a creature scored by another simulator is scored by this one",
          "[persist][older_versions]") {
    const auto before = load_creature(kVersions / "older_simulator/walker.creature.json", kinds());
    REQUIRE(before);
    CHECK(other_simulator(*before) ==
          "scored by simulator 0.9, this is " + std::string(kSimulatorVersion));
    const auto after = rescored(*before, kinds());
    REQUIRE(after);
    CHECK_FALSE(other_simulator(*after));
    CHECK(after->score() != before->score());
    CHECK(after->notes.ticks != before->notes.ticks);
    CreatureDocument expected = *before;
    expected.notes = after->notes;
    change_individual(expected.creature,
                      [&](Individual& individual) { individual.result = after->result(); });
    CHECK(write_creature(*after, kinds()) == write_creature(expected, kinds()));
    CHECK(same_judgement(after->settings(), before->settings()));
    CHECK(same_score(*rescored(*after, kinds()), *after));
}

TEST_CASE("a score that cannot be replaced is left", "[persist][older_versions]") {
    auto document = load_creature(kVersions / "older_simulator/walker.creature.json", kinds());
    REQUIRE(document);
    std::stop_source stopped;
    stopped.request_stop();
    CHECK(rescored(*document, kinds(), stopped.get_token()).error().message == "interrupted");
    change_settings(document->creature, [](ExperimentSettings& settings) {
        settings.world.scene.max_evaluations = 100.0;
    });
    CHECK_THAT(rescored(*document, kinds()).error().message, Catch::Contains("over-budget"));
    document->creature.individual = without_score(*document->creature.individual);
    CHECK_THAT(rescored(*document, kinds()).error().message, Catch::Contains("no score"));
}

TEST_CASE("settings of any version are read", "[persist][older_versions]") {
    const std::string version = GENERATE("1");
    const auto settings = load_settings(kVersions / version / "settings.toml", kinds());
    REQUIRE(settings);
    CHECK(settings->population.size == 8);
    CHECK(settings->world.trial.duration == 0.5);
}

// -- samples of every version of every format, from tests/persist/versions/samples/

namespace {

// Returns the number in a name such as "experiment-4.cambrian".
std::int64_t number_in(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    return std::stoll(name.substr(name.find('-') + 1));
}

void check_creature(const Result<CreatureDocument>& document, const std::string& text,
                    std::int64_t version) {
    INFO((document ? "" : document.error().message));
    REQUIRE(document);
    CHECK(document->warnings.empty());
    CHECK(document->scored());
    CHECK_THAT(text, Catch::Contains("\"version\": " + std::to_string(version)));
}

void check_sample(const std::filesystem::path& path) {
    const std::string kind = path.filename().string().substr(0, path.filename().string().find('-'));
    INFO(path.filename().string());
    if (kind == "experiment") {
        CHECK(version_in(path) == number_in(path));
        const auto saved = load_experiment(path, kinds());
        INFO((saved ? "" : saved.error().message));
        REQUIRE(saved);
        CHECK(saved->latest->history.size() == 2);
    } else if (kind == "preserve") {
        CHECK(version_in(path) == number_in(path));
        const auto saved = load_preserve(path, kinds());
        INFO((saved ? "" : saved.error().message));
        REQUIRE(saved);
        CHECK(load_snapshot(path, saved->snapshots.back(), kinds()));
    } else if (kind == "creature" || kind == "card") {
        const std::string bytes = bytes_of(path);
        const std::string text = kind == "card" ? *card_document(bytes, path.string()) : bytes;
        check_creature(load_creature(path, kinds()), text, number_in(path));
    } else {
        REQUIRE(kind == "settings");
        const std::string text = bytes_of(path);
        const auto settings = parse_settings(text, path.string(), kinds(), use_of_settings(text));
        INFO((settings ? "" : settings.error().message));
        CHECK(settings);
    }
}

}  // namespace

TEST_CASE("samples of every version of every format are read", "[persist][older_versions]") {
    const TemporaryDirectory folder;
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kVersions / "samples")) {
        if (entry.path().extension() == ".md") continue;
        std::filesystem::copy(entry.path(), folder / entry.path().filename().string());
        check_sample(folder / entry.path().filename().string());
        ++count;
    }
    CHECK(count >= 7);
}

TEST_CASE("there is a sample of the present version of every format", "[persist][older_versions]") {
    for (const std::string& name :
         {"experiment-" + std::to_string(kExperimentVersion) + ".cambrian",
          "preserve-" + std::to_string(kPreserveVersion) + ".cambrian",
          "creature-" + std::to_string(creature_format::kVersion) + ".creature.json",
          "card-" + std::to_string(creature_format::kVersion) + ".card.png"}) {
        INFO(name << " is missing; tests/persist/versions/samples/README.md says how to make it");
        CHECK(std::filesystem::exists(kVersions / "samples" / name));
    }
}
