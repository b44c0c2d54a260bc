#include "persist/experiment/experiment_file.h"

#include "evolution/individual/ancestry_digest.h"
#include "evolution/individual/population_digest.h"
#include "persist/creature/creature_file.h"
#include "persist/creature/rescoring.h"
#include "persist/experiment/experiment_parts.h"
#include "persist/experiment/kept_experiment.h"
#include "persist/records/experiment_schema.h"
#include "persist/settings/settings_file.h"
#include "persist/steered_run.h"
#include "support/build_speed.h"
#include "support/temporary_directory.h"

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace cambrian;
using namespace cambrian::test;

namespace {

SettingsPtr shared(const ExperimentSettings& settings) {
    return std::make_shared<const ExperimentSettings>(settings);
}

using Existing = ExperimentFile::Existing;

// Creates an experiment file; an empty path gives a file without a name.
std::shared_ptr<ExperimentFile> new_file(const std::filesystem::path& path,
                                         const SettingsPtr& settings,
                                         const std::vector<GenomePtr>& founders = {}) {
    const auto file = ExperimentFile::create(kinds(), settings, founders);
    REQUIRE(file);
    if (!path.empty()) REQUIRE((*file)->move_to(path, Existing::kRefuse));
    return *file;
}

// Writes and closes the file of a run of so many generations.
void write_run(const std::filesystem::path& path, const ExperimentSettings& settings,
               std::size_t generations, const std::vector<NotedCommand>& steering = {}) {
    const auto file = new_file(path, shared(settings));
    Evolution evolution(shared(settings), kinds());
    run_on(evolution, *file, generations, steering);
}

// A run with its open file; an empty name gives a file without a name.
struct KeptRun {
    explicit KeptRun(const std::string& name = "a.cambrian")
        : path(name.empty() ? std::filesystem::path() : folder / name) {}

    TemporaryDirectory folder;
    std::filesystem::path path;
    SettingsPtr settings = shared(small_settings());
    std::shared_ptr<ExperimentFile> file = new_file(path, settings);
    Evolution evolution{settings, kinds()};
};

std::vector<std::uint64_t> digests_of(const std::filesystem::path& path) {
    const auto saved = load_experiment(path, kinds());
    INFO((saved ? "" : saved.error().message));
    REQUIRE(saved);
    return saved->digests;
}

void check_equal(const Individual& a, const Individual& b) {
    CHECK(a.uid == b.uid);
    CHECK(a.born == b.born);
    CHECK(a.body_born == b.body_born);
    CHECK(a.parents == b.parents);
    CHECK(a.method == b.method);
    CHECK(a.genome_hash == b.genome_hash);
    CHECK(*a.genome == *b.genome);
    CHECK(a.genome->hue == b.genome->hue);
    CHECK(a.mutations.size() == b.mutations.size());
    CHECK(a.result.fitness == b.result.fitness);
    CHECK(a.result.outcome == b.result.outcome);
    CHECK(a.result.reason == b.result.reason);
    CHECK(a.result.digest == b.result.digest);
    CHECK(a.result.phenotype == b.result.phenotype);
    CHECK(a.result.plan == b.result.plan);
    CHECK(a.result.scores == b.result.scores);
    CHECK(a.line == b.line);
    CHECK(a.result.behavior == b.result.behavior);
    CHECK(a.result.work == b.result.work);
    CHECK(a.result.verdict == b.result.verdict);
    CHECK(a.result.finer == b.result.finer);
    CHECK(a.result.audit.energy_residual == b.result.audit.energy_residual);
    CHECK(a.result.audit.fallbacks == b.result.audit.fallbacks);
}

std::string refusal(const std::filesystem::path& path) {
    const auto opened = open_experiment(path, kinds());
    REQUIRE_FALSE(opened);
    return opened.error().message;
}

}  // namespace

TEST_CASE("a population comes back as it was written", "[persist][experiment_file]") {
    KeptRun run;
    run_on(run.evolution, *run.file, 4);
    const auto saved = load_experiment(run.path, kinds());
    REQUIRE(saved);
    REQUIRE(saved->latest);
    CHECK(saved->latest->generation == 3);
    CHECK(write_settings(*saved->latest->settings, kinds()) ==
          write_settings(*run.settings, kinds()));
    REQUIRE(saved->latest->population.size() == run.evolution.population().size());
    for (std::size_t i = 0; i < run.evolution.population().size(); ++i)
        check_equal(*saved->latest->population[i], *run.evolution.population()[i]);
    CHECK(saved->digests.back() == population_digest(run.evolution.population()));
    CHECK(saved->champions.size() == 4);
    CHECK(saved->latest->history.back().best == run.evolution.history().back().best);
    const auto confirmed = [](const IndividualPtr& one) { return !one->result.scores.empty(); };
    CHECK(
        std::any_of(saved->latest->population.begin(), saved->latest->population.end(), confirmed));
    for (std::size_t i = 0; i < 4; ++i) {
        const GenerationStatistics& written = run.evolution.history()[i];
        const GenerationStatistics& read = saved->latest->history[i];
        CHECK(read.lines == written.lines);
        CHECK(read.plans == written.plans);
        CHECK(read.births == written.births);
        CHECK(read.confirmations == written.confirmations);
        CHECK(read.best_lowest == written.best_lowest);
    }
}

TEST_CASE("lines of descent come back to their beginning", "[persist][experiment_file]") {
    KeptRun run;
    run_on(run.evolution, *run.file, 8);
    const auto saved = load_experiment(run.path, kinds());
    REQUIRE(saved);
    std::size_t generations = 0;
    for (std::size_t i = 0; i < run.evolution.population().size(); ++i) {
        IndividualPtr original = run.evolution.population()[i];
        IndividualPtr copy = saved->latest->population[i];
        CHECK(ancestry_digest(*copy) == ancestry_digest(*original));
        for (; original; ++generations) {
            REQUIRE(copy);
            CHECK(copy->uid == original->uid);
            CHECK(copy->result.fitness == original->result.fitness);
            CHECK(*copy->genome == *original->genome);
            original = original->mother.get();
            copy = copy->mother.get();
        }
        CHECK_FALSE(copy);
    }
    CHECK(generations > 2 * run.evolution.population().size());
}

TEST_CASE("resumed at any generation a run goes on as if never stopped",
          "[persist][experiment_file]") {
    const std::string selection =
        GENERATE("truncation", "roulette", "novelty", "map-elites", "age-protection");
    const TemporaryDirectory folder;
    constexpr std::size_t kGenerations = by_build<std::size_t>(6, 4);
    ExperimentSettings settings = small_settings(selection);
    settings.terminate_early = selection == "truncation";
    const auto steering = some_steering(settings);
    write_run(folder / "complete.cambrian", settings, kGenerations, steering);
    const auto expected = digests_of(folder / "complete.cambrian");
    for (std::size_t stop = 1; stop < kGenerations; ++stop) {
        const std::filesystem::path path = folder / ("stopped" + std::to_string(stop));
        write_run(path, settings, stop, steering);
        {
            auto opened = open_experiment(path, kinds());
            REQUIRE(opened);
            Evolution evolution = resumed(opened->saved, kinds());
            CHECK(evolution.generation() == stop);
            run_on(evolution, *opened->file, kGenerations, steering);
        }
        CHECK(digests_of(path) == expected);
    }
}

TEST_CASE("a run with founders from a museum goes on as if never stopped",
          "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    ExperimentSettings settings = small_settings();
    settings.population.museum = 0.2;
    const std::vector<GenomePtr> founders = {crawler(kinds().creature.catalog)};
    const auto write = [&](const std::filesystem::path& path, std::size_t generations) {
        const auto file = new_file(path, shared(settings), founders);
        Evolution evolution(shared(settings), kinds(), founders);
        run_on(evolution, *file, generations);
    };
    write(folder / "complete.cambrian", 4);
    write(folder / "stopped.cambrian", 2);
    {
        auto opened = open_experiment(folder / "stopped.cambrian", kinds());
        REQUIRE(opened);
        Evolution evolution = resumed(opened->saved, kinds());
        run_on(evolution, *opened->file, 4);
    }
    CHECK(digests_of(folder / "stopped.cambrian") == digests_of(folder / "complete.cambrian"));
    const auto saved = load_experiment(folder / "stopped.cambrian", kinds());
    const auto& last = saved->latest->population;
    CHECK(std::any_of(last.begin(), last.end(), [](const IndividualPtr& one) {
        return one->born == 3 && one->method == "imported";
    }));
}

TEST_CASE("a resumed contest goes on as if never stopped, with its opponents",
          "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    constexpr std::size_t kGenerations = 5;
    ExperimentSettings settings = small_settings();
    settings.goal = "competition";
    settings.world.trial.has_cube = true;
    settings.world.trial.trials = 3;
    write_run(folder / "complete.cambrian", settings, kGenerations);
    const auto complete = load_experiment(folder / "complete.cambrian", kinds());
    REQUIRE(complete);
    for (const JudgedIndividual& champion : complete->champions) {
        CHECK(champion.settings->world.opponents.genomes.size() == 3);
        const EvaluationResult again = run_scored_trial({.creature = champion}, kinds());
        CHECK(again.digest == champion.individual->result.digest);
        CHECK(again.fitness == unconfirmed_score(champion.individual->result));
    }
    for (const std::size_t stop : {1U, 3U}) {
        const std::filesystem::path path = folder / ("stopped" + std::to_string(stop));
        write_run(path, settings, stop);
        {
            auto opened = open_experiment(path, kinds());
            REQUIRE(opened);
            Evolution evolution = resumed(opened->saved, kinds());
            run_on(evolution, *opened->file, kGenerations);
        }
        CHECK(digests_of(path) == complete->digests);
    }
}

TEST_CASE("a creature file keeps the opponents of its contest", "[persist][experiment_file]") {
    ExperimentSettings settings = small_settings();
    settings.goal = "competition";
    settings.world.trial.has_cube = true;
    settings.world.trial.trials = 2;
    settings.world.opponents.genomes = {crawler(kinds().creature.catalog),
                                        fish(kinds().creature.catalog)};
    JudgedIndividual creature = unjudged(crawler(kinds().creature.catalog), shared(settings));
    change_individual(creature, [](Individual& each) { each.evaluated = true; });
    CreatureDocument document{.creature = creature, .notes = {.unit = "points"}};
    const EvaluationResult result = run_scored_trial(document, kinds());
    change_individual(document.creature, [&](Individual& each) { each.result = result; });
    const std::string text = write_creature(document, kinds());
    const auto read = parse_creature(text, "it", kinds());
    REQUIRE(read);
    CHECK(read->settings().world.opponents == settings.world.opponents);
    CHECK(same_score(*read, document));
    CHECK(write_creature(*read, kinds()) == text);
    const EvaluationResult again = run_scored_trial(*read, kinds());
    CHECK(again.digest == document.result().digest);
}

TEST_CASE("commands given to a generation that was never finished are not lost",
          "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    const ExperimentSettings settings = small_settings();
    write_run(folder / "a.cambrian", settings, 2);
    ExperimentSettings moon = settings;
    moon.world.environment.gravity = 1.62;
    {
        const auto opened = open_experiment(folder / "a.cambrian", kinds());
        REQUIRE(opened);
        REQUIRE(opened->file->note({2, ChangeSettings{shared(moon)}}));
    }
    const auto saved = load_experiment(folder / "a.cambrian", kinds());
    REQUIRE(saved);
    const Evolution evolution = resumed(*saved, kinds());
    CHECK(evolution.settings().world.environment.gravity == 1.62);
    CHECK(setting_changes(*saved).size() == 2);
}

TEST_CASE("an experiment that has not begun to be judged keeps its founders",
          "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    const GenomePtr founder = crawler(kinds().creature.catalog);
    new_file(folder / "a.cambrian", shared(small_settings()), {founder});
    const auto opened = open_experiment(folder / "a.cambrian", kinds());
    REQUIRE(opened);
    CHECK_FALSE(opened->saved.latest);
    const Evolution evolution = resumed(opened->saved, kinds());
    CHECK(*evolution.population().front()->genome == *founder);
}

TEST_CASE("minus zero is not zero in a file", "[persist][experiment_file]") {
    Database database({}, Database::Access::kCreate);
    database.execute("CREATE TABLE t (" + column_definitions<Behavior>(kBehaviorColumns) + ")");
    Behavior behavior;
    behavior.travel = -0.0;
    Statement insertion = database.prepare("INSERT INTO t VALUES (?" + more_places(6) + ")");
    insertion.restart();
    bind_columns<Behavior>(insertion, kBehaviorColumns, behavior);
    insertion.finish();
    Statement selection = database.prepare("SELECT * FROM t");
    REQUIRE(selection.step());
    Behavior read;
    read_columns<Behavior>(selection, 0, kBehaviorColumns, read);
    CHECK(std::signbit(read.travel));
}

TEST_CASE("genotypes of individuals that neither survived nor had children are deleted",
          "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    write_run(folder / "a.cambrian", small_settings(), 12);
    const Database database(folder / "a.cambrian", Database::Access::kRead);
    const auto individuals = database.integer("SELECT count(*) FROM individuals");
    const auto genotypes = database.integer("SELECT count(*) FROM genotypes");
    const auto results = database.integer("SELECT count(*) FROM results");
    CHECK(individuals > 100);
    CHECK(genotypes < individuals * 2 / 3);
    CHECK(results <= 14 + 12);
    CHECK(database.integer("SELECT count(*) FROM generations JOIN genotypes ON individual = "
                           "champion") == 12);
}

TEST_CASE("a star keeps each score it was given, although its individual is dropped elsewhere",
          "[persist][experiment_file]") {
    KeptRun run;
    run_on(run.evolution, *run.file, 2);
    std::vector<JudgedIndividual> stars;
    const auto star_all = [&] {
        for (const IndividualPtr& each : run.evolution.population())
            stars.push_back({run.evolution.generation(), each, run.evolution.shared_settings()});
        REQUIRE(run.file->keep_stars(stars));
    };
    star_all();
    ExperimentSettings moon = *run.settings;
    moon.world.environment.gravity = 1.62;
    run_on(run.evolution, *run.file, 3,
           // A change of world, after which survivors are evaluated again.
           {{2, ChangeSettings{shared(moon)}}});
    star_all();
    run_on(run.evolution, *run.file, 9);
    const auto path = run.folder / "b.cambrian";
    std::filesystem::copy(run.path, path);
    if (std::filesystem::exists(run.folder / "a.cambrian-wal"))
        std::filesystem::copy(run.folder / "a.cambrian-wal", run.folder / "b.cambrian-wal");
    const auto opened = open_experiment(path, kinds());
    INFO((opened ? "" : opened.error().message));
    REQUIRE(opened);
    REQUIRE(opened->stars.size() == stars.size());
    for (std::size_t i = 0; i < stars.size(); ++i)
        check_equal(*opened->stars[i].individual, *stars[i].individual);
}

TEST_CASE("a star given before the run has a file is kept with its first generation",
          "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    const std::filesystem::path path = folder / "own.cambrian";
    const SettingsPtr settings = shared(small_settings());
    KeptRun elsewhere("");
    run_on(elsewhere.evolution, *elsewhere.file, 1);
    const JudgedIndividual star = {0, elsewhere.evolution.population().front(), settings};
    {
        KeptExperiment kept(path, kinds());
        REQUIRE(kept.begin(settings, {}));
        REQUIRE(kept.keep_stars({star}));
        CHECK_FALSE(kept.took_autosave());
        Evolution evolution(settings, kinds());
        run_on(evolution, kept, 1);
        CHECK(kept.took_autosave());
    }
    const auto opened = open_experiment(path, kinds());
    REQUIRE(opened);
    REQUIRE(opened->stars.size() == 1);
    check_equal(*opened->stars.front().individual, *star.individual);
}

TEST_CASE("an experiment moves to another file and goes on there", "[persist][experiment_file]") {
    const auto steering = some_steering(small_settings());
    const std::string origin = GENERATE("a.cambrian", "");
    KeptRun run(origin);
    const std::filesystem::path complete = run.folder / "complete.cambrian";
    const std::filesystem::path other = run.folder / "b.cambrian";
    write_run(complete, small_settings(), 6, steering);
    run_on(run.evolution, *run.file, 3, steering);
    std::ofstream(other) << "something else";
    REQUIRE(run.file->move_to(other));
    CHECK(run.file->path() == other);
    run_on(run.evolution, *run.file, 6, steering);
    CHECK(digests_of(other) == digests_of(complete));
    if (!origin.empty()) CHECK(digests_of(run.path).size() == 3);
}

TEST_CASE("an experiment that is removed or replaced is not written to",
          "[persist][experiment_file]") {
    KeptRun run;
    run_on(run.evolution, *run.file, 1);
    std::filesystem::remove(run.path);
    const Status refused = run.file->record(run.evolution);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, Catch::Contains("removed or replaced"));
    CHECK_FALSE(std::filesystem::exists(run.path));
    REQUIRE(run.file->move_to(run.folder / "b.cambrian"));
    CHECK(digests_of(run.folder / "b.cambrian").size() == 1);
}

TEST_CASE("one experiment is open in one place only", "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    write_run(folder / "a.cambrian", small_settings(), 1);
    const auto opened = open_experiment(folder / "a.cambrian", kinds());
    REQUIRE(opened);
    CHECK_THAT(refusal(folder / "a.cambrian"), Catch::Contains("open in another window"));
    CHECK(load_experiment(folder / "a.cambrian", kinds()));
}

TEST_CASE("what is no experiment is refused and stays as it was", "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    CHECK_THAT(refusal(folder / "none.cambrian"), Catch::Contains("No such file"));
    CHECK_FALSE(std::filesystem::exists(folder / "none.cambrian"));
    std::ofstream(folder / "text.cambrian") << std::string(5000, 'x');
    CHECK_THAT(refusal(folder / "text.cambrian"), Catch::Contains("not an SQLite database"));
    std::ofstream(folder / "empty.cambrian").flush();
    CHECK_THAT(refusal(folder / "empty.cambrian"), Catch::Contains("another program's"));
    {
        Database(folder / "other.cambrian", Database::Access::kCreate)
            .execute("CREATE TABLE t (a)");
    }
    CHECK_THAT(refusal(folder / "other.cambrian"), Catch::Contains("another program's"));
    CHECK(std::filesystem::file_size(folder / "empty.cambrian") == 0);
    const auto existing = new_file({}, shared(small_settings()))
                              ->move_to(folder / "text.cambrian", Existing::kRefuse);
    REQUIRE_FALSE(existing);
    CHECK_THAT(existing.error().message, Catch::Contains("File exists"));
    CHECK(std::filesystem::file_size(folder / "text.cambrian") == 5000);
}

TEST_CASE("an experiment that has the most changes of settings takes no more",
          "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    const auto path = folder / "a.cambrian";
    write_run(path, small_settings(), 2);
    Database(path, Database::Access::kWrite)
        .execute(
            "INSERT INTO journal (generation, command, settings) WITH RECURSIVE n(i) AS "
            "(SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 5000) SELECT 1, 'settings', 1 FROM "
            "n");
    auto opened = open_experiment(path, kinds());
    REQUIRE(opened);
    const Status noted = opened->file->note({1, ChangeSettings{shared(small_settings())}});
    REQUIRE_FALSE(noted);
    CHECK_THAT(noted.error().message, Catch::Contains("5000 changes of settings"));
}

TEST_CASE("the audited champion takes the place of the best by score, and the run goes on",
          "[persist][experiment_file]") {
    KeptRun run;
    run_on(run.evolution, *run.file, 3);
    const auto crowned = [&](std::size_t place) {
        Individual audited = *run.evolution.population().at(place);
        audited.result.scores = {audited.result.fitness, 0.25, -0.5};
        audited.result.fitness = 0.25;
        const JudgedIndividual champion{run.evolution.generation(),
                                        std::make_shared<const Individual>(audited),
                                        run.evolution.shared_settings()};
        REQUIRE(run.file->crown(champion));
        return champion;
    };
    // The last of the ranking, whose genotype would be deleted; it is crowned twice.
    const JudgedIndividual first = crowned(13);
    const JudgedIndividual last = crowned(13);
    const auto check = [&](const JudgedIndividual& champion) {
        CHECK(champion.generation == 2);
        check_equal(*champion.individual, *last.individual);
    };
    const auto digests = digests_of(run.path);
    check(load_experiment(run.path, kinds())->champions.back());
    check(load_champion(run.path, std::nullopt, kinds())->creature);
    run.file.reset();
    {
        const auto opened = open_experiment(run.path, kinds());
        REQUIRE(opened);
        check(opened->saved.champions.back());
        // Ancestors are known as before.
        const auto mother = run.evolution.population().at(13)->mother.get();
        const auto kept = opened->saved.champions.back().individual->mother.get();
        REQUIRE((kept == nullptr) == (mother == nullptr));
        if (kept != nullptr) CHECK(kept->uid == mother->uid);
        Evolution later = resumed(opened->saved, kinds());
        REQUIRE(opened->file->keep_stars({opened->saved.champions.back()}));
        run_on(later, *opened->file, 6);
    }
    CHECK(digests_of(run.path)[2] == digests[2]);
    check(load_experiment(run.path, kinds())->champions[2]);
    check(load_champion(run.path, 2, kinds())->creature);
    KeptRun never_crowned("b.cambrian");
    run_on(never_crowned.evolution, *never_crowned.file, 6);
    CHECK(digests_of(run.path) == digests_of(never_crowned.path));
}

TEST_CASE("a champion is read without the rest of its experiment", "[persist][experiment_file]") {
    const TemporaryDirectory folder;
    const auto path = folder / "a.cambrian";
    write_run(path, small_settings(), 3);
    const auto complete = load_experiment(path, kinds());
    REQUIRE(complete);
    Database(path, Database::Access::kWrite).execute("DELETE FROM population");
    REQUIRE_FALSE(load_experiment(path, kinds()));
    for (const std::uint32_t generation : {0U, 1U, 2U}) {
        const auto kept = load_champion(path, generation, kinds());
        REQUIRE(kept);
        const JudgedIndividual& expected = complete->champions[generation];
        CHECK(kept->creature.generation == generation);
        check_equal(*kept->creature.individual, *expected.individual);
        CHECK(kept->creature.settings->seed == expected.settings->seed);
        CHECK(kept->simulator == kSimulatorVersion);
    }
    CHECK(load_champion(path, std::nullopt, kinds())->creature.generation == 2);
    const auto later = load_champion(path, 3, kinds());
    REQUIRE_FALSE(later);
    CHECK_THAT(later.error().message, Catch::Contains("no generation 3; the last is 2"));
}

TEST_CASE("whatever is wrong inside an experiment is one message", "[persist][experiment_file]") {
    const auto [sql, words] = GENERATE(table<std::string, std::string>({
        {"PRAGMA user_version = 99", "its version 99 is newer than this program (4)"},
        {"PRAGMA user_version = 0", "its version 0 never existed"},
        {"DROP TABLE novel", "table \"novel\" is missing"},
        {"ALTER TABLE novel ADD COLUMN more", "table \"novel\" has other columns"},
        {"DELETE FROM journal", "the journal has no beginning"},
        {"UPDATE journal SET command = 'explode' WHERE id = 2", "unknown command \"explode\""},
        {"INSERT INTO journal (generation, command, settings) WITH RECURSIVE n(i) AS "
         "(SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 5001) SELECT 1, 'settings', 1 FROM n",
         "more than 5000 changes of settings"},
        {"UPDATE journal SET share = 2 WHERE id = 2", "newcomers is outside [0, 1]"},
        {"UPDATE journal SET share = NULL WHERE id = 2", "newcomers is outside [0, 1]"},
        {"DELETE FROM generations WHERE generation = 1", "generation 1 is missing"},
        {"UPDATE generations SET best = 'good'", "column \"best\": expected a number"},
        {"UPDATE settings SET toml = 'nonsense'", "settings 1"},
        {"UPDATE settings SET toml = printf('#%200000s', 'x')",
         "a text of 200001 bytes; expected at most 100000"},
        {"UPDATE individuals SET mutations = printf('[%200000s]', '')",
         "a text of 200002 bytes; expected at most 100000"},
        {"DELETE FROM results", "its score is missing"},
        {"DELETE FROM genotypes", "its genotype is missing"},
        {"UPDATE genotypes SET document = x'00'", "cannot be decompressed"},
        {"UPDATE genotypes SET size = -1", "size is negative"},
        {"UPDATE genotypes SET size = 100000000", "genotype too large"},
        {"UPDATE genotypes SET document = (SELECT document FROM genotypes LIMIT 1), "
         "size = (SELECT size FROM genotypes LIMIT 1)",
         "its genotype is another's"},
        {"UPDATE individuals SET mother = id", "it is older than its mother"},
        {"UPDATE individuals SET mother = 1000000 WHERE mother IS NOT NULL",
         "it is older than its mother"},
        {"UPDATE individuals SET mutations = '[1]'", "mutations"},
        {"UPDATE individuals SET born = -1", "-1 is too large or too small"},
        {"UPDATE results SET outcome = 'won'", "\"won\" is no outcome"},
        {"UPDATE results SET travel = 9e999", "travel is not a number"},
        {"UPDATE results SET fitness = 7", "not the one that was written"},
        {"DELETE FROM population WHERE place = 3", "not the one that was written"},
        {"DELETE FROM population", "not the one that was written"},
        {"UPDATE population SET individual = 99999", "is missing"},
    }));
    const TemporaryDirectory folder;
    const auto path = folder / "a.cambrian";
    write_run(path, small_settings(), 3, {{1, AddImmigrants{0.3}}});
    Database(path, Database::Access::kWrite).execute(sql);
    INFO(sql);
    CHECK_THAT(refusal(path), Catch::Contains(words) && Catch::Contains(path.string()));
    const auto loaded = load_experiment(path, kinds());
    CHECK_FALSE(loaded);
}
