// Preserves with ground and gravity.
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "support/build_speed.h"
#include "support/temporary_directory.h"
#include "worlds.h"

#include <algorithm>
#include <string>

namespace cambrian {
namespace {

using namespace test;

ExperimentSettings land(const char* bodies = "ghostly") {
    ExperimentSettings settings = preserve_defaults(kinds(), true);
    settings.preserve.bodies = bodies;
    settings.preserve.width = 30.0;
    settings.preserve.height = 8.0;
    settings.preserve.founders = 10;
    settings.preserve.energy_density = 100.0;
    return settings;
}

GenomePtr sample(const std::string& name) {
    const std::filesystem::path folder = CAMBRIAN_SOURCE_DIR "/assets/creatures";
    const auto read = load_creature(folder / (name + ".creature.json"), kinds());
    REQUIRE(read);
    return read->creature.individual->genome;
}

std::vector<GenomePtr> walkers() {
    return {sample("walker"), sample("crawler"), eater(0.0)};
}

bool stands(const Resident& resident) {
    return resident.bounds().low.y() == Approx(kStartClearance);
}

TEST_CASE("a world with ground has the defaults of land, and others those of water",
          "[preserve][ground]") {
    const auto read = [](const std::string& text) {
        return parse_settings(text, "land.toml", kinds(), SettingsUse::kPreserve);
    };
    const auto meadow = read("[environment]\nground = true\n");
    REQUIRE(meadow);
    CHECK(meadow->preserve.bodies == "ghostly");
    CHECK(meadow->world.environment == Environment{});
    const auto solid = read("[preserve]\nbodies = \"solid\"\n[environment]\nground = true\n");
    REQUIRE(solid);
    CHECK(solid->preserve.bodies == "solid");
    const auto pond = read("[environment]\nground = false\n");
    REQUIRE(pond);
    CHECK(pond->preserve.bodies == "solid");
    CHECK(pond->world.environment.gravity == 0.0);
    const std::string text = write_settings(*meadow, kinds(), SettingsUse::kPreserve);
    CHECK_THAT(text, Catch::Contains("default \"ghostly\"") && Catch::Contains("plant-height"));
    const auto again = read(text);
    REQUIRE(again);
    CHECK(write_settings(*again, kinds(), SettingsUse::kPreserve) == text);
    const auto low = read("[preserve]\nwalls = \"0 -1 2 3\"\n[environment]\nground = true\n");
    REQUIRE_FALSE(low);
    CHECK(low.error().message ==
          "land.toml: [preserve] walls: wall 1: an end is outside the world, which has 40 m x 25 m "
          "above the ground");
    CHECK(read("[preserve]\nwalls = \"0 0 2 25\"\n[environment]\nground = true\n"));
    CHECK_FALSE(read("[preserve]\npatches = \"0 -1 2\"\n[environment]\nground = true\n"));
}

TEST_CASE("founders, children and what people add and move begin standing on the ground",
          "[preserve][ground]") {
    for (const char* bodies : {"ghostly", "solid"}) {
        const auto preserve = begun(land(bodies), walkers());
        REQUIRE(preserve->residents().size() == 10);
        CHECK(std::all_of(preserve->residents().begin(), preserve->residents().end(),
                          [](const auto& each) { return stands(*each); }));
        REQUIRE(preserve->intervene(
            {.what = intervention::kAdd, .x = 99.0, .y = 7.0, .genome = sample("walker")}));
        CHECK(stands(*preserve->residents().back()));
        CHECK(preserve->residents().back()->center().x() > 10.0);
        ThreadPool pool(1);
        std::size_t born = 0;
        for (int tick = 0; tick < 1500 && born < 3; ++tick) {
            const std::uint64_t last = preserve->residents().back()->life.number;
            preserve->tick(pool);
            for (const auto& each : preserve->residents()) {
                if (each->life.number <= last) continue;
                ++born;
                CHECK(stands(*each));
            }
        }
        CHECK(born >= 3);
        const std::uint64_t moved = preserve->residents().front()->life.number;
        REQUIRE(preserve->intervene(
            {.what = intervention::kMove, .number = moved, .x = -5.0, .y = 6.0}));
        CHECK(stands(*preserve->residents().front()));
        CHECK(preserve->total_energy() == preserve->founding_energy());
    }
}

TEST_CASE("plants grow up to their height, and flesh lies on the ground", "[preserve][ground]") {
    ExperimentSettings settings = land();
    settings.preserve.plant_height = 0.4;
    settings.preserve.patches = "5 3 1";
    const auto preserve = begun(settings, walkers());
    REQUIRE(preserve->intervene({.what = intervention::kFeed, .x = 1.0, .y = 6.0}));
    REQUIRE(preserve->intervene({.what = intervention::kRemove, .number = 1}));
    double middle = 0.0;
    double height = 0.0;
    for (const Pellet& plant : preserve->plants().all()) {
        CHECK(plant.y >= 0.0);
        CHECK(plant.y <= 0.4);
        middle += plant.x;
        height += plant.y;
    }
    const auto count = static_cast<double>(preserve->plants().all().size());
    CHECK(middle / count == Approx(5.0).margin(0.5));
    CHECK(height / count == Approx(0.2).margin(0.02));
    REQUIRE_FALSE(preserve->flesh().all().empty());
    for (const Pellet& piece : preserve->flesh().all())
        CHECK(piece.y == 0.0);
}

TEST_CASE("nobody sinks into the ground or breaks on it, and energy is constant",
          "[preserve][ground]") {
    for (const char* bodies : {"ghostly", "solid"}) {
        ExperimentSettings settings = land(bodies);
        settings.preserve.width = 16.0;
        settings.preserve.founders = 6;
        settings.preserve.energy_density = 200.0;
        const auto preserve = begun(settings, walkers());
        ThreadPool pool(1);
        double lowest = 0.0;
        std::size_t broken = 0;
        const int ticks = by_build(1800, 600);
        for (int tick = 0; tick < ticks; ++tick) {
            preserve->tick(pool);
            REQUIRE(preserve->total_energy() == preserve->founding_energy());
            for (const auto& each : preserve->residents())
                lowest = std::min(lowest, each->bounds().low.y());
            for (const Life& life : preserve->take_chronicle().died)
                broken += life.cause == DeathCause::kBrokenPhysics ? 1 : 0;
        }
        CHECK(lowest > -0.05);
        CHECK(broken == 0);
        CHECK((preserve->solid_counts().joined_ticks > 100) == (bodies == std::string("solid")));
    }
}

TEST_CASE("a walker on ground moves exactly as in a scene of its own", "[preserve][ground]") {
    ExperimentSettings settings = land();
    settings.preserve.founders = 1;
    settings.preserve.max_population = 1;
    settings.preserve.restock = 0;
    settings.preserve.width = 200.0;
    const auto preserve = begun(settings, {sample("walker")});
    check_moved_as_alone(*preserve, settings, {sample("walker")});
}

TEST_CASE("threads do not change the bits of solid creatures on ground",
          "[preserve][ground][threads]") {
    ExperimentSettings settings = land("solid");
    settings.preserve.width = 40.0;
    settings.preserve.founders = 14;
    check_same_on_any_threads(settings, walkers(), 300, 50);
}

TEST_CASE("a world with ground goes on from its file with the same bits, and a replay repeats it",
          "[preserve][ground]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "meadow.cambrian";
    KeptWorld world = kept_in(path, land());
    Preserve& uncut = *world.preserve;
    run_to(uncut, 60);
    REQUIRE(uncut.intervene({.what = intervention::kFeed, .x = 1.0, .y = 1.0}));
    REQUIRE(uncut.intervene({.what = intervention::kRest}));
    REQUIRE(world.file->write(uncut.take_chronicle(), uncut));
    run_to(uncut, 400);
    world.file.reset();
    repeated_from(path, world, 0);
    CHECK(check_goes_on(path, world.founders, uncut)->world.environment.has_ground);
}

}  // namespace
}  // namespace cambrian
