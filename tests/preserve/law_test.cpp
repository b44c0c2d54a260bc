// Laws that change while a preserve goes on.
#include "persist/sqlite/database.h"
#include "preserve/laws.h"
#include "support/temporary_directory.h"
#include "worlds.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace cambrian {
namespace {

using namespace test;

const SettingField& law(const std::string& key) {
    static const std::vector<SettingField> laws = changeable_laws(kinds());
    const auto found = std::find_if(laws.begin(), laws.end(),
                                    [&](const SettingField& each) { return each.key == key; });
    REQUIRE(found != laws.end());
    return *found;
}

double present(const Preserve& preserve, const std::string& key) {
    ExperimentSettings laws = *preserve.laws();
    return law_value(law(key), laws);
}

std::string refusal(Preserve& preserve, const Intervention& asked) {
    const auto done = preserve.intervene(asked);
    return done ? "" : done.error().message;
}

struct Change {
    std::string key;
    double value;
};
// Changes that show within a quarter of a minute, and those that need a chance.
const std::vector<Change> kSeen = {
    {"growth-time", 20.0}, {"plant-energy", 5.0},     {"flesh-half-life", 10.0},
    {"body-upkeep", 2.0},  {"neuron-upkeep", 0.05},   {"aging-time", 20.0},
    {"bite-power", 80.0},  {"birth-interval", 50.0},  {"max-population", 1.0},
    {"restock", 30.0},     {"viscosity-linear", 0.8}, {"viscosity-quadratic", 3.0},
};
const std::vector<Change> kUnseen = {{"organ-upkeep", 1.0}, {"rate", 2.0}};

TEST_CASE("each law changes at once and leaves the sum of energy alone", "[preserve][law]") {
    ExperimentSettings settings = small_world();
    settings.preserve.energy_density = 300.0;
    settings.preserve.growth_time = 60.0;
    const auto unchanged = begun(settings, {eater(0.0), eater(1.0)});
    run_to(*unchanged, 910);
    CHECK(changeable_laws(kinds()).size() == kSeen.size() + kUnseen.size());
    for (const auto& [key, value] : kSeen) {
        INFO(key);
        const auto preserve = begun(settings, {eater(0.0), eater(1.0)});
        run_to(*preserve, 10);
        REQUIRE(preserve->intervene(law_change(law(key), value)));
        CHECK(present(*preserve, key) == value);
        CHECK(*preserve->settings() == settings);
        run_to(*preserve, 910);
        CHECK(preserve->total_energy() == preserve->founding_energy());
        CHECK(digest(*preserve) != digest(*unchanged));
    }
    for (const auto& [key, value] : kUnseen) {
        REQUIRE(unchanged->intervene(law_change(law(key), value)));
        CHECK(present(*unchanged, key) == value);
    }
}

TEST_CASE("a law that is unknown or cannot have a value has a message and changes nothing",
          "[preserve][law]") {
    const auto preserve = begun(small_world(), {eater(0.0)});
    const auto before = preserve->laws();
    CHECK(refusal(*preserve, law_change(law("growth-time"), -1.0)) ==
          "Growth time: -1 is not a number from 1 to 1000000 s");
    CHECK(refusal(*preserve, law_change(law("restock"), 8.5)) ==
          "Restock below: 8.5 is not a whole number from 0 to 1000 creatures");
    CHECK(refusal(*preserve, {.what = "law preserve.width", .x = 20.0}) ==
          "there is no law \"preserve.width\" that can be changed; known are "
          "preserve.growth-time, preserve.plant-energy, preserve.flesh-half-life, "
          "preserve.body-upkeep, preserve.neuron-upkeep, preserve.organ-upkeep, "
          "preserve.aging-time, preserve.bite-power, preserve.birth-interval, "
          "preserve.max-population, preserve.restock, mutation.rate, "
          "environment.viscosity-linear, environment.viscosity-quadratic");
    CHECK(preserve->laws() == before);
    CHECK(preserve->take_chronicle().interventions.empty());
}

TEST_CASE("changed laws are repeated by a replay and hold after reopening", "[preserve][law]") {
    ExperimentSettings settings = small_world();
    settings.preserve.bodies = GENERATE("ghostly", "solid");
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    KeptWorld world = kept_in(path, settings);
    run_to(*world.preserve, 100);
    REQUIRE(world.preserve->intervene(law_change(law("viscosity-linear"), 0.8)));
    REQUIRE(world.preserve->intervene(law_change(law("growth-time"), 30.0)));
    REQUIRE(world.preserve->intervene(law_change(law("plant-energy"), 4.0)));
    for (const std::uint64_t tick : {500U, 1000U}) {
        run_to(*world.preserve, tick);
        REQUIRE(world.preserve->intervene({.what = intervention::kRest}));
        REQUIRE(world.file->write(world.preserve->take_chronicle(), *world.preserve));
    }
    CHECK(repeated_from(path, world, 0).size() == 4);
    CHECK(repeated_from(path, world, 1).size() == 1);
    world.file.reset();
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    const auto resumed = Preserve::resume(opened->origin.settings, kinds(), opened->origin.founders,
                                          opened->state, opened->laws);
    REQUIRE(resumed);
    CHECK(present(**resumed, "viscosity-linear") == 0.8);
    CHECK(present(**resumed, "growth-time") == 30.0);
    run_to(**resumed, 1400);
    run_to(*world.preserve, 1400);
    CHECK(digest(**resumed) == digest(*world.preserve));
    const auto forgetful =
        Preserve::resume(opened->origin.settings, kinds(), opened->origin.founders, opened->state);
    REQUIRE(forgetful);
    run_to(**forgetful, 1400);
    CHECK(digest(**forgetful) != digest(*world.preserve));
}

TEST_CASE("a file with a change of a law that is not allowed has a message", "[preserve][law]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    {
        KeptWorld world = kept_in(path, small_world());
        run_to(*world.preserve, 10);
        REQUIRE(world.preserve->intervene(law_change(law("growth-time"), 30.0)));
        REQUIRE(world.preserve->intervene({.what = intervention::kRest}));
        REQUIRE(world.file->write(world.preserve->take_chronicle(), *world.preserve));
    }
    {
        Database database(path, Database::Access::kWrite);
        database.execute("UPDATE interventions SET x = -3.0 WHERE what LIKE 'law %'");
    }
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE_FALSE(opened);
    CHECK_THAT(opened.error().message,
               Catch::Contains("Growth time: -3 is not a number from 1 to 1000000 s"));
}

TEST_CASE("a file of version 4, which has no changed laws, is brought to the present one",
          "[preserve][law]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    changed_in(path, "ALTER TABLE genotypes DROP COLUMN base; PRAGMA user_version = 4");
    REQUIRE(load_museum(path, kinds()));
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    CHECK(opened->laws == opened->origin.settings);
    CHECK(Database(path, Database::Access::kRead).integer("PRAGMA user_version") == 6);
}

}  // namespace
}  // namespace cambrian
