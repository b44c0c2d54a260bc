#include "persist/experiment/experiment_file.h"
#include "persist/preserve/preserve_file.h"
#include "persist/sqlite/database.h"
#include "simulator/simulator_version.h"
#include "support/build_speed.h"
#include "support/temporary_directory.h"
#include "worlds.h"

namespace cambrian {
namespace {

using namespace test;

FindOrigin origins_of(const PreserveState& state) {
    return [&state](std::uint64_t number) -> Result<Origin> {
        for (const ResidentState& each : state.residents) {
            if (each.life.number == number) return Origin{each.life.genome, each.life.method};
        }
        for (const Lineage& lineage : state.lineages) {
            if (lineage.number == number) return Origin{lineage.genome, ""};
        }
        return Error{"missing"};
    };
}

TEST_CASE("a preserve that goes on from a snapshot has the bits of one that never stopped",
          "[preserve]") {
    const ExperimentSettings settings = small_world();
    const std::vector<GenomePtr> founders = {eater(0.0), eater(1.0), fish(kind_catalog())};
    const auto uncut = begun(settings, founders);
    run_to(*uncut, kTicksPerSnapshot);
    const auto snapshot = uncut->take_chronicle().snapshot;
    REQUIRE(snapshot);
    const std::vector<std::uint64_t> words = words_of(*snapshot);
    const auto state = state_of(words, origins_of(*snapshot));
    REQUIRE(state);
    CHECK(words_of(*state) == words);
    const std::uint64_t end = kTicksPerSnapshot + by_build<std::uint64_t>(kTicksPerSnapshot, 600);
    run_to(*uncut, end);
    const auto resumed = Preserve::resume(std::make_shared<const ExperimentSettings>(settings),
                                          kinds(), founders, *state);
    REQUIRE(resumed);
    run_to(**resumed, end);
    CHECK(digest(**resumed) == digest(*uncut));
}

TEST_CASE("a file of before founders could be rhythmic says that none is", "[preserve]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    kept_in(path, small_world());
    CHECK(load_preserve(path, kinds())->origin.settings->founders.rhythmic_share == 1.0);
    Database(path, Database::Access::kWrite)
        .execute(
            "UPDATE facts SET value = replace(value, char(10) || 'rhythmic = 1.0', '') WHERE "
            "name = 'settings'");
    const auto loaded = load_preserve(path, kinds());
    REQUIRE(loaded);
    CHECK(loaded->origin.settings->founders.rhythmic_share == 0.0);
}

TEST_CASE("damaged words of a snapshot give a message", "[preserve]") {
    const ExperimentSettings settings = small_world();
    const auto preserve = begun(settings, {eater(0.0)});
    run_to(*preserve, 60);
    const PreserveState complete = preserve->save();
    const std::vector<std::uint64_t> words = words_of(complete);
    const auto shared = std::make_shared<const ExperimentSettings>(settings);
    int refused = 0;
    for (std::size_t place = 0; place < words.size(); place += 7) {
        std::vector<std::uint64_t> damaged = words;
        damaged[place] = ~damaged[place];
        const auto state = state_of(damaged, origins_of(complete));
        const bool usable =
            state && Preserve::resume(shared, kinds(), {eater(0.0)}, *state).has_value();
        refused += usable ? 0 : 1;
    }
    CHECK(refused > 0);
    const std::span<const std::uint64_t> all(words);
    CHECK_FALSE(state_of(all.first(words.size() - 1), origins_of(complete)));
    CHECK_FALSE(state_of({}, origins_of(complete)));
}

TEST_CASE("a preserve file keeps lives, series and snapshots, and goes on", "[preserve]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    KeptWorld world = kept_in(path, small_world());
    Preserve& preserve = *world.preserve;
    run_to(preserve, kTicksPerSnapshot);
    REQUIRE(world.file->write(preserve.take_chronicle(), preserve));
    run_to(preserve, kTicksPerSnapshot + 700);
    REQUIRE(world.file->write(preserve.take_chronicle(), preserve));
    CHECK_FALSE(PreserveFile::open(path, kinds()));
    world.file.reset();
    CHECK(is_preserve_file(path));
    const auto saved = load_preserve(path, kinds());
    REQUIRE(saved);
    CHECK(saved->origin.founders.size() == 2);
    REQUIRE(saved->snapshots.size() == 2);
    CHECK(saved->snapshots.back().tick == kTicksPerSnapshot);
    const auto series = series_csv(path);
    REQUIRE(series);
    CHECK(std::count(series->begin(), series->end(), '\n') == 1 + 7);
    const auto uncut_lives = lives_csv(path);
    auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    CHECK(opened->warnings.empty());
    CHECK(std::ranges::count(*series_csv(path), '\n') == 1 + 6);
    const auto resumed =
        Preserve::resume(opened->origin.settings, kinds(), opened->origin.founders, opened->state);
    REQUIRE(resumed);
    run_to(**resumed, kTicksPerSnapshot + 700);
    REQUIRE(opened->file->write((*resumed)->take_chronicle(), **resumed));
    CHECK(digest(**resumed) == digest(preserve));
    CHECK(*lives_csv(path) == *uncut_lives);
    CHECK(*series_csv(path) == *series);
}

TEST_CASE("a snapshot that says it is huge is refused before it is inflated", "[preserve]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    KeptWorld world = kept_in(path, small_world());
    world.file.reset();
    const auto message_with = [&](const std::string& change) {
        Database(path, Database::Access::kWrite).execute(change);
        const auto saved = load_preserve(path, kinds());
        REQUIRE(saved);
        const auto state = load_snapshot(path, saved->snapshots.front(), kinds());
        return state ? std::string() : state.error().message;
    };
    CHECK_THAT(message_with("UPDATE snapshots SET size = 268435456"),  // 2 GB
               Catch::EndsWith("the snapshot has 268435456 numbers; expected at most 16000000"));
    CHECK_THAT(message_with("UPDATE snapshots SET size = 15000000"),
               Catch::EndsWith("the snapshot has fewer numbers than it says"));
    CHECK_THAT(message_with("UPDATE snapshots SET size = -1"),
               Catch::Contains("expected at most 16000000"));
    CHECK_FALSE(PreserveFile::open(path, kinds()));
}

TEST_CASE("a file with a million lives is read without keeping them all", "[preserve]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    changed_in(
        path,
        "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1000000) "
        "INSERT INTO lives SELECT i + 1000, uid, parent1, parent2, lineage, method, mutations, "
        "born, died, cause, x, y, mass, parts, neurons, diet, eaten_plants, eaten_flesh, "
        "bitten, lost, children FROM n, (SELECT * FROM lives LIMIT 1)");
    const auto saved = load_preserve(path, kinds());
    REQUIRE(saved);
    const auto state = load_snapshot(path, saved->snapshots.front(), kinds());
    REQUIRE(state);
    CHECK(state->residents.size() == 10);
    const auto museum = load_museum(path, kinds());
    REQUIRE(museum);
    CHECK(museum->empty());
    // Going on removes what was born after the snapshot.
    REQUIRE(PreserveFile::open(path, kinds()));
    CHECK(std::ranges::count(*lives_csv(path), '\n') == 1 + 10);
}

TEST_CASE("a preserve file is no experiment, and an experiment no preserve", "[preserve]") {
    const TemporaryDirectory folder;
    const auto pond = folder.path() / "pond.cambrian";
    const auto run = folder.path() / "run.cambrian";
    const auto settings = std::make_shared<const ExperimentSettings>(small_world());
    const auto preserve = begun(*settings, {eater(0.0)});
    REQUIRE(PreserveFile::create(pond, {settings, {eater(0.0)}, std::string(kSimulatorVersion)},
                                 preserve->take_chronicle(), *preserve, kinds()));
    const auto experiment =
        ExperimentFile::create(kinds(), std::make_shared<const ExperimentSettings>(), {});
    REQUIRE(experiment);
    REQUIRE((*experiment)->move_to(run, ExperimentFile::Existing::kRefuse));
    const auto wrong = load_experiment(pond, kinds());
    REQUIRE_FALSE(wrong);
    CHECK_THAT(wrong.error().message,
               Catch::EndsWith("it is a preserve, no experiment; `cambrian preserve --resume` "
                               "goes on with it"));
    const auto other = load_preserve(run, kinds());
    REQUIRE_FALSE(other);
    CHECK_THAT(other.error().message,
               Catch::EndsWith("it is an experiment, no preserve; `cambrian evolve --resume` goes "
                               "on with it"));
}

}  // namespace
}  // namespace cambrian
