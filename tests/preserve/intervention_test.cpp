#include "persist/preserve/preserve_file.h"
#include "persist/sqlite/database.h"
#include "preserve/replay.h"
#include "simulator/simulator_version.h"
#include "support/temporary_directory.h"
#include "worlds.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace cambrian {
namespace {

using namespace test;

// Does one of each kind, to the third and the fourth creature.
void interfere(Preserve& preserve) {
    const std::uint64_t moved = preserve.residents()[2]->life.number;
    const std::uint64_t removed = preserve.residents()[3]->life.number;
    REQUIRE(preserve.intervene({.what = intervention::kFeed, .x = 1.0, .y = -2.0}));
    REQUIRE(preserve.intervene({.what = intervention::kMove, .number = moved, .x = 2.0, .y = 2.0}));
    REQUIRE(preserve.intervene({.what = intervention::kRemove, .number = removed}));
    REQUIRE(preserve.intervene({.what = intervention::kRest}));
    REQUIRE(preserve.intervene(
        {.what = intervention::kAdd, .x = 50.0, .y = 0.0, .genome = eater(0.5, 0.3)}));
}

TEST_CASE("what people do neither makes nor loses energy", "[preserve]") {
    const auto preserve = begun(small_world(), {eater(0.0), eater(1.0)});
    run_to(*preserve, 20);
    const auto plants = preserve->plants().all().size();
    interfere(*preserve);
    CHECK(preserve->total_energy() == preserve->founding_energy());
    CHECK(preserve->plants().all().size() == plants + 10);
    CHECK(preserve->residents().size() == 10);
    CHECK(preserve->residents()[2]->center().x() == Approx(2.0));
    const Resident& added = *preserve->residents().back();
    CHECK(added.life.number == 11);
    CHECK(added.life.method == "added");
    CHECK(added.center().x() == Approx(6.0 - added.radius()));
    const Chronicle chronicle = preserve->take_chronicle();
    REQUIRE(chronicle.died.size() == 1);
    CHECK(chronicle.died.front().cause == DeathCause::kRemoved);
    CHECK(chronicle.interventions.size() == 5);
}

TEST_CASE("what cannot be done has a message and changes nothing", "[preserve]") {
    ExperimentSettings settings = small_world();
    const auto preserve = begun(settings, {eater(0.0)});
    const std::uint64_t before = digest(*preserve);
    CHECK_FALSE(preserve->intervene({.what = intervention::kRemove, .number = 99}));
    CHECK_FALSE(preserve->intervene({.what = "tickle", .number = 1}));
    CHECK_FALSE(preserve->intervene({.what = intervention::kFeed, .x = std::nan("")}));
    CreatureBuilder stone(kind_catalog());
    stone.part(0.4, 0.4);
    CHECK_FALSE(preserve->intervene({.what = intervention::kAdd, .genome = stone.build()}));
    CHECK(digest(*preserve) == before);
    Result<std::uint64_t> added = std::uint64_t{0};
    for (int i = 0; i < 1000 && added; ++i)
        added = preserve->intervene({.what = intervention::kAdd, .genome = eater(0.0, 0.6)});
    REQUIRE_FALSE(added);
    CHECK_THAT(added.error().message, Catch::Contains("the creature costs"));
    CHECK(preserve->total_energy() == preserve->founding_energy());
}

TEST_CASE("a file repeats what people did, from each snapshot to the next", "[preserve]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    KeptWorld world = kept_in(path, small_world());
    Preserve& preserve = *world.preserve;
    run_to(preserve, 30);
    interfere(preserve);
    REQUIRE(preserve.intervene({.what = intervention::kRest}));
    REQUIRE(world.file->write(preserve.take_chronicle(), preserve));
    run_to(preserve, 50);
    interfere(preserve);
    REQUIRE(world.file->write(preserve.take_chronicle(), preserve));
    CHECK(world.file->snapshots() == std::vector<std::uint64_t>{0, 30, 50});
    REQUIRE(preserve.intervene({.what = intervention::kRest}));
    REQUIRE(world.file->write(preserve.take_chronicle(), preserve));
    world.file.reset();
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(repeated_from(path, world, i).size() == 6);
    const auto branch = folder.path() / "branch.cambrian";
    CHECK_FALSE(copy_preserve(path, 31, branch, kinds()));
    REQUIRE(copy_preserve(path, 30, branch, kinds()));
    CHECK_FALSE(copy_preserve(path, 30, branch, kinds()));
    const auto opened = PreserveFile::open(branch, kinds());
    REQUIRE(opened);
    CHECK(opened->state.tick == 30);
    CHECK(load_preserve(branch, kinds())->interventions.size() == 6);
}

TEST_CASE("what people did after the last snapshot of a killed program is forgotten",
          "[preserve]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    const auto settings = std::make_shared<const ExperimentSettings>(small_world());
    const auto preserve = begun(*settings, {eater(0.0)});
    {
        auto file = PreserveFile::create(path, {settings, {eater(0.0)}, "1"},
                                         preserve->take_chronicle(), *preserve, kinds());
        REQUIRE(file);
        interfere(*preserve);
        REQUIRE((*file)->write(preserve->take_chronicle(), *preserve));
    }
    auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    CHECK(opened->state.residents.size() == 9);
    const auto saved = load_preserve(path, kinds());
    REQUIRE(saved);
    REQUIRE(saved->interventions.size() == 4);
    CHECK(saved->interventions.back().what == intervention::kRest);
    const auto resumed = Preserve::resume(settings, kinds(), {eater(0.0)}, opened->state);
    REQUIRE(resumed);
    interfere(**resumed);
    REQUIRE(opened->file->write((*resumed)->take_chronicle(), **resumed));
}

TEST_CASE("a file of version 1 is opened and brought to the present one", "[preserve]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    const auto settings = std::make_shared<const ExperimentSettings>(small_world());
    const auto preserve = begun(*settings, {eater(0.0)});
    REQUIRE(PreserveFile::create(path, {settings, {eater(0.0)}, "1"}, preserve->take_chronicle(),
                                 *preserve, kinds()));
    {
        Database database(path, Database::Access::kWrite);
        database.execute(
            "ALTER TABLE interventions DROP COLUMN x; ALTER TABLE interventions DROP COLUMN y;"
            "ALTER TABLE interventions DROP COLUMN to_x; ALTER TABLE interventions DROP COLUMN "
            "to_y; DROP TABLE museum; ALTER TABLE genotypes DROP COLUMN base;"
            "INSERT INTO interventions (tick, what, number) VALUES (0, 'restock', 1);"
            "PRAGMA user_version = 1");
    }
    CHECK(load_preserve(path, kinds())->interventions.empty());
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    interfere(*preserve);
    CHECK(opened->file->write(preserve->take_chronicle(), *preserve));
    CHECK(load_preserve(path, kinds())->interventions.size() == 5);
}

}  // namespace
}  // namespace cambrian
