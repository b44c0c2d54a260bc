// Walls within a preserve, from settings and drawn by people.
#include "persist/preserve/preserve_file.h"
#include "preserve/replay.h"
#include "simulator/simulator_version.h"
#include "support/temporary_directory.h"
#include "worlds.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace cambrian {
namespace {

using namespace test;

Intervention wall(double x, double y, double to_x, double to_y) {
    return {.what = intervention::kWall, .x = x, .y = y, .to_x = to_x, .to_y = to_y};
}

ExperimentSettings divided_world(const char* bodies) {
    ExperimentSettings settings = small_world();
    settings.preserve.bodies = bodies;
    settings.preserve.walls = "0 -5 0 5";
    return settings;
}

std::size_t on_the_left(const Preserve& preserve) {
    return static_cast<std::size_t>(
        std::count_if(preserve.residents().begin(), preserve.residents().end(),
                      [](const auto& each) { return each->center().x() < 0.0; }));
}

std::size_t in_walls(const Preserve& preserve) {
    return static_cast<std::size_t>(
        std::count_if(preserve.residents().begin(), preserve.residents().end(),
                      [&](const auto& each) { return preserve.walls().meet(each->rectangles()); }));
}

TEST_CASE("nobody passes a wall from side to side", "[preserve][wall]") {
    for (const char* bodies : {"solid", "ghostly"}) {
        ExperimentSettings settings = divided_world(bodies);
        settings.preserve.restock = 0;
        const auto preserve = begun(settings, {fish(kind_catalog())});
        CHECK(in_walls(*preserve) == 0);
        std::map<std::uint64_t, bool> sides;
        for (const auto& each : preserve->residents())
            sides[each->life.number] = each->center().x() < 0.0;
        const std::size_t left = on_the_left(*preserve);
        CHECK(left > 0);
        CHECK(left < preserve->residents().size());
        run_to(*preserve, 1200);
        std::size_t same = 0;
        for (const auto& each : preserve->residents()) {
            const auto known = sides.find(each->life.number);
            if (known == sides.end()) continue;
            CHECK(known->second == (each->center().x() < 0.0));
            ++same;
        }
        CHECK(same > 0);
        CHECK(preserve->total_energy() == preserve->founding_energy());
    }
}

TEST_CASE("a drawn wall moves what is in its way, and stays until it is erased",
          "[preserve][wall]") {
    const auto preserve = begun(small_world(), {fish(kind_catalog())});
    const Vec3 place = preserve->residents().front()->center();
    const double x = place.x();
    REQUIRE(preserve->intervene(wall(x, -5.0, x, 5.0)));
    CHECK(in_walls(*preserve) == 0);
    REQUIRE(preserve->walls().lines().size() == 1);
    CHECK(preserve->intervene(wall(-2.0, 4.5, 2.0, 4.5)).value() == 2);
    REQUIRE(preserve->intervene({.what = intervention::kRest}));
    CHECK(preserve->walls().lines().size() == 2);
    run_to(*preserve, 30);
    CHECK_FALSE(preserve->intervene({.what = intervention::kErase, .x = -5.9, .y = -4.9}));
    CHECK(preserve->intervene({.what = intervention::kErase, .x = 1.9, .y = 4.4}).value() == 1);
    CHECK(preserve->walls().lines().front().from.x() == x);
    const Chronicle chronicle = preserve->take_chronicle();
    REQUIRE(chronicle.interventions.size() == 4);
    CHECK(chronicle.interventions[1].to_x == 2.0);
}

TEST_CASE("what is no wall has a message and changes nothing", "[preserve][wall]") {
    const auto preserve = begun(small_world(), {fish(kind_catalog())});
    const std::uint64_t before = digest(*preserve);
    const auto message = [&](const Intervention& asked) {
        const auto built = preserve->intervene(asked);
        return built ? std::string() : built.error().message;
    };
    CHECK(message(wall(1.0, 1.0, 1.0, 1.0)) ==
          "This wall cannot be built: it is 0 m long; expected at least 0.2 m.");
    CHECK(message(wall(0.0, 0.0, 7.0, 0.0)) ==
          "This wall cannot be built: an end is outside the world, which has 12 m x 10 m.");
    CHECK_THAT(message(wall(0.0, 0.0, 0.0, std::nan(""))), Catch::Contains("not finite"));
    CHECK(message({.what = intervention::kErase}) == "There is no wall here to erase.");
    CHECK(digest(*preserve) == before);
    for (int i = 0; i < kMostFixedBoxes; ++i)
        REQUIRE(preserve->intervene(wall(-6.0, -5.0, -5.8, -5.0)));
    CHECK(message(wall(0.0, 0.0, 1.0, 0.0)) ==
          "There are 64 walls already, the most there can be.");
}

TEST_CASE("a file repeats walls, and those of version 2 are read and brought to the present one",
          "[preserve][wall]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    const KeptWorld world = changed_in(
        path,
        "ALTER TABLE interventions DROP COLUMN to_x; ALTER TABLE interventions DROP COLUMN to_y; "
        "DROP TABLE museum; ALTER TABLE genotypes DROP COLUMN base; PRAGMA user_version = 2");
    REQUIRE(load_preserve(path, kinds()));
    {
        auto opened = PreserveFile::open(path, kinds());
        REQUIRE(opened);
        const auto preserve =
            Preserve::resume(world.settings, kinds(), world.founders, opened->state);
        REQUIRE(preserve);
        for (const double x : {-1.0, 2.0}) {
            run_to(**preserve, (*preserve)->ticks() + 40);
            REQUIRE((*preserve)->intervene(wall(x, -5.0, x, 5.0)));
            run_to(**preserve, (*preserve)->ticks() + 40);
            REQUIRE((*preserve)->intervene({.what = intervention::kErase, .x = x, .y = 0.0}));
            REQUIRE((*preserve)->intervene(wall(x, -5.0, x, 4.0)));
            REQUIRE((*preserve)->intervene({.what = intervention::kRest}));
            REQUIRE(opened->file->write((*preserve)->take_chronicle(), **preserve));
        }
    }
    const auto saved = load_preserve(path, kinds());
    REQUIRE(saved);
    REQUIRE(saved->snapshots.size() == 3);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto state = load_snapshot(path, saved->snapshots[i], kinds());
        REQUIRE(state);
        CHECK(state->walls.size() == i);
        repeated_from(path, world, i);
    }
}

}  // namespace
}  // namespace cambrian
