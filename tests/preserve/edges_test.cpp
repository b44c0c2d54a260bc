// Preserves whose opposite edges meet.
#include "persist/creature/creature_file.h"
#include "preserve/engine/preserve_picture.h"
#include "support/build_speed.h"
#include "support/temporary_directory.h"
#include "worlds.h"

#include <algorithm>
#include <string>

namespace cambrian {
namespace {

using namespace test;

// A world of 12 m x 10 m in which creatures sink to the right, round and round.
ExperimentSettings wrapped(const char* bodies = "ghostly") {
    ExperimentSettings settings = small_world();
    settings.preserve.edges = "wrap";
    settings.preserve.bodies = bodies;
    settings.world.environment.gravity = 25.0;
    settings.world.environment.gravity_direction = 10.0;
    return settings;
}

ExperimentSettings wrapped_for(int creatures, const char* bodies) {
    ExperimentSettings settings = wrapped(bodies);
    settings.preserve.founders = creatures;
    settings.preserve.max_population = creatures;
    settings.preserve.restock = 0;
    return settings;
}

// Returns the same without gravity, for creatures that remain where they are put.
ExperimentSettings still_for(int creatures, const char* bodies) {
    ExperimentSettings settings = wrapped_for(creatures, bodies);
    settings.world.environment.gravity = 0.0;
    return settings;
}

Intervention move_to(std::uint64_t number, double x, double y) {
    return {.what = intervention::kMove, .number = number, .x = x, .y = y};
}

WorldArea area_in(const Preserve& preserve) {
    return area_of(preserve.settings()->preserve, preserve.settings()->world.environment);
}

TEST_CASE("a creature that meets nobody goes round the world as in a scene of its own",
          "[preserve][edges]") {
    for (const char* bodies : {"ghostly", "solid"}) {
        const ExperimentSettings settings = wrapped_for(1, bodies);
        const auto preserve = begun(settings, {eater(0.0)});
        check_moved_as_alone(*preserve, settings, {eater(0.0)});
        const Resident& moved = *preserve->residents().front();
        CHECK(moved.center().x() > 1.5 * settings.preserve.width);
        CHECK(moved.life.eaten_plants > 0);
    }
}

TEST_CASE("a creature goes on with its velocity where it crosses an edge", "[preserve][edges]") {
    const auto preserve = begun(wrapped_for(1, "solid"), {fish(kind_catalog())});
    ThreadPool pool(1);
    const Resident& moved = *preserve->residents().front();
    PreserveCamera camera;
    int crossed = 0;
    Vec3 before = moved.center();
    for (int tick = 0; tick < 600; ++tick) {
        const Vec3 velocity = moved.velocity();
        preserve->tick(pool);
        CHECK((moved.velocity() - velocity).norm() < 0.5);
        CHECK((moved.center() - before).norm() < 0.2);
        before = moved.center();
        PreservePicture picture;
        camera.take(*preserve, picture);
        const ResidentPicture& shown = picture.residents.front();
        REQUIRE(picture.area.contains(shown.center));
        CHECK((shown.parts[0].center - shown.center)
                  .isApprox(moved.rectangles()[0].center - moved.center()));
        crossed += shown.center.x() < 0.0 && moved.center().x() > 6.0 ? 1 : 0;
    }
    CHECK(crossed > 0);
}

TEST_CASE("a creature eats what lies beyond an edge", "[preserve][edges]") {
    const auto preserve = begun(still_for(1, "solid"), {eater(0.0)});
    const Resident& resident = *preserve->residents().front();
    REQUIRE(preserve->intervene(move_to(1, 5.99, 4.99)));
    REQUIRE(preserve->intervene({.what = intervention::kFeed, .x = -5.95, .y = -4.95}));
    const std::size_t plants = preserve->plants().all().size();
    run_to(*preserve, 1);
    CHECK(resident.life.eaten_plants > 0);
    CHECK(preserve->plants().all().size() < plants);
    CHECK(preserve->total_energy() == preserve->founding_energy());
}

TEST_CASE("creatures bite each other across an edge, and mate", "[preserve][edges]") {
    for (const char* bodies : {"ghostly", "solid"}) {
        ExperimentSettings settings = still_for(2, bodies);
        settings.preserve.width = 300.0;
        const auto preserve = begun(settings, {eater(1.0, 0.4)});
        REQUIRE(preserve->intervene(move_to(1, 149.9, 0.0)));
        const Resident& first = *preserve->residents().front();
        const Resident& second = *preserve->residents().back();
        const double gap = is_solid(settings.preserve) ? 0.002 : -0.3;
        REQUIRE(preserve->intervene(move_to(
            2, first.bounds().high.x() + gap + second.center().x() - second.bounds().low.x(),
            first.center().y())));
        CHECK(second.center().x() < -149.0);
        Energy bitten = 0;
        for (std::uint64_t tick = 1; tick <= 120 && preserve->residents().size() == 2; ++tick) {
            run_to(*preserve, tick);
            for (const auto& each : preserve->residents())
                bitten += each->life.bitten;
        }
        CHECK(bitten > 0);
        CHECK((preserve->solid_counts().joined_ticks > 0) == is_solid(settings.preserve));
        CHECK(preserve->total_energy() == preserve->founding_energy());
    }
    ExperimentSettings settings = still_for(2, "ghostly");
    settings.preserve.max_population = 20;
    settings.preserve.width = 300.0;
    settings.preserve.birth_interval = 1.0;
    settings.preserve.energy_density = 10.0;
    settings.breeding.shares = {{"crossover", 1.0}};
    const auto preserve = begun(settings, {eater(0.0)});
    REQUIRE(preserve->intervene(move_to(1, 149.0, 0.0)));
    REQUIRE(preserve->intervene(move_to(2, -149.0, 1.0)));
    std::size_t both = 0;
    for (std::uint64_t tick = 1; tick <= 600 && both == 0; ++tick) {
        if (tick % 60 == 1)
            REQUIRE(preserve->intervene({.what = intervention::kFeed, .x = 149.0, .y = 0.0}));
        run_to(*preserve, tick);
        for (const Life& born : preserve->take_chronicle().born)
            both += born.parents[0] != 0 && born.parents[1] != 0 ? 1U : 0U;
    }
    CHECK(both > 0);
}

TEST_CASE("smells, sounds and light come across edges", "[preserve][edges]") {
    Environment environment;
    environment.has_light = true;
    environment.light_x = 5.0;
    environment.light_y = 0.0;
    // Neither side is a multiple of a cell of smells: there are 24 x 20.
    const WorldArea area{12.2, 9.9, false, true};
    const Vec3 corner(0.5 * 12.2 - 0.5 * 12.2 / 24.0, 0.5 * 9.9 - 0.5 * 9.9 / 20.0, 0.0);
    CommonSenses senses(area, environment);
    Food plants(area);
    const Food flesh(area);
    plants.add(corner, 1'000'000'000);
    for (std::uint64_t tick = 6; tick <= 120; tick += 6) {
        senses.begin_tick();
        senses.take({.sounds = {{Vec3(42.0, 0.0, 0.0), 1, 1.0}}, .scents = {}}, 1);
        senses.end_tick(tick, plants, flesh);
    }
    const double here = senses.plant_smell(corner - Vec3(0.5, 0.4, 0.0));
    CHECK(here > 0.0);
    for (const Vec3& apart : {Vec3(0.5, -0.4, 0.0), Vec3(-0.5, 0.4, 0.0), Vec3(0.5, 0.4, 0.0)}) {
        const Vec3 beyond = area.torus().shortest(corner + apart);
        CHECK((beyond - corner).norm() > 5.0);
        CHECK(senses.plant_smell(beyond) == Approx(here));
    }
    CHECK(senses.plant_smell({0.0, 0.0, 0.0}) < 1e-3 * here);
    CHECK(senses.plant_smell(corner + Vec3(122.5, -99.4, 0.0)) == Approx(here));
    // 42 m is 5.4 m in the area.
    CHECK(senses.sound({-6.0, 0.0, 0.0}, 1, 2) == Approx(1.0 / 1.8));
    CHECK(senses.light({-5.2, 0.0, 0.0}).direction.x() == Approx(-1.0));
    CHECK(senses.light({-5.2, 0.0, 0.0}).intensity == Approx(1.0 / (1.0 + 4.0 / 4.0)));
}

TEST_CASE("nobody passes the images of a wall", "[preserve][edges][wall]") {
    for (const char* bodies : {"ghostly", "solid"}) {
        ExperimentSettings settings = wrapped_for(5, bodies);
        settings.preserve.walls = "3 -5 3 5";
        const auto preserve = begun(settings, {fish(kind_catalog())});
        std::vector<double> walls;  // to the right of each
        for (const auto& each : preserve->residents())
            walls.push_back(each->center().x() < 3.0 ? 3.0 : 15.0);
        run_to(*preserve, 900);
        REQUIRE(preserve->residents().size() == 5);
        for (std::size_t i = 0; i < walls.size(); ++i) {
            const Resident& each = *preserve->residents()[i];
            // Those that met others may have been moved to beside them.
            const double gap = std::fmod(walls[i] - each.center().x() + 24.0, 12.0);
            CHECK(gap < 3.0);
            CHECK_FALSE(preserve->walls().meet(
                std::vector<Rectangle>{{each.center(), Vec3::UnitX(), 0.01, 0.01}}));
        }
    }
}

TEST_CASE("people build, erase, move and add across edges", "[preserve][edges][wall]") {
    const auto preserve = begun(still_for(3, "solid"), {eater(0.0)});
    const WorldArea area = area_in(*preserve);
    REQUIRE(preserve->intervene(move_to(1, -5.9, 0.0)));
    REQUIRE(preserve->intervene(
        {.what = intervention::kWall, .x = 17.5, .y = 0.0, .to_x = 18.5, .to_y = 0.0}));
    const WallLine& wall = preserve->walls().lines().front();
    CHECK(wall.from == Vec3(5.5, 0.0, 0.0));
    CHECK(wall.to == Vec3(6.5, 0.0, 0.0));
    CHECK_FALSE(preserve->walls().meet(preserve->residents().front()->rectangles()));
    CHECK(preserve->walls().meet({Vec3(-5.6, -0.1, 0.0), Vec3(-5.4, 0.1, 0.0)}));
    CHECK(preserve->walls().separate({6.2, -1.0, 0.0}, {6.2, 1.0, 0.0}));
    CHECK(preserve->walls().separate({-29.8, 9.0, 0.0}, {-29.8, 11.0, 0.0}));
    REQUIRE(preserve->intervene({.what = intervention::kErase, .x = -5.6, .y = 0.4}));
    CHECK(preserve->walls().lines().empty());
    REQUIRE(preserve->intervene(move_to(2, 99.0, -77.0)));
    CHECK(area.contains(preserve->residents()[1]->center()));
    CHECK(preserve->residents()[1]->center().isApprox(Vec3(3.0, 3.0, 0.0)));
    // There is no room on the other one.
    REQUIRE(preserve->intervene(move_to(3, 3.0 + 12.0, 3.0 - 10.0)));
    CHECK((preserve->residents()[2]->center() - Vec3(3.0, 3.0, 0.0)).norm() > 0.1);
    CHECK(preserve->total_energy() == preserve->founding_energy());
}

TEST_CASE("creatures are born in the area, and energy is constant", "[preserve][edges]") {
    for (const char* bodies : {"ghostly", "solid"}) {
        ExperimentSettings settings = wrapped(bodies);
        settings.preserve.energy_density = 300.0;
        settings.preserve.birth_interval = 2.0;
        const auto preserve = begun(settings, {eater(0.0), eater(1.0)});
        const WorldArea area = area_in(*preserve);
        ThreadPool pool(1);
        std::size_t born = 0;
        const int ticks = by_build(900, 400);
        for (int tick = 0; tick < ticks; ++tick) {
            preserve->tick(pool);
            REQUIRE(preserve->total_energy() == preserve->founding_energy());
            for (const Life& life : preserve->take_chronicle().born) {
                ++born;
                CHECK(area.contains({life.x, life.y, 0.0}));
            }
        }
        CHECK(born > 10);
        for (const Pellet& each : preserve->flesh().all())
            CHECK(area.contains(each.place()));
        for (const Pellet& each : preserve->plants().all())
            CHECK(area.contains(each.place()));
    }
}

TEST_CASE("threads do not change the bits of a world whose edges meet",
          "[preserve][edges][threads]") {
    ExperimentSettings settings = wrapped("solid");
    settings.preserve.founders = 24;
    settings.preserve.walls = "3 -2 8 2";
    check_same_on_any_threads(settings, {eater(0.0), eater(1.0), fish(kind_catalog())}, 300, 100);
}

TEST_CASE("a world whose edges meet goes on from its file with the same bits",
          "[preserve][edges]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    ExperimentSettings settings = wrapped("solid");
    settings.preserve.walls = "3 -2 8 2";
    KeptWorld world = kept_in(path, settings);
    Preserve& uncut = *world.preserve;
    run_to(uncut, 200);
    REQUIRE(uncut.intervene(
        {.what = intervention::kWall, .x = -18.0, .y = 1.0, .to_x = -17.0, .to_y = 1.0}));
    REQUIRE(uncut.intervene({.what = intervention::kRest}));
    REQUIRE(world.file->write(uncut.take_chronicle(), uncut));
    run_to(uncut, 600);
    world.file.reset();
    repeated_from(path, world, 0);
    CHECK(check_goes_on(path, world.founders, uncut)->preserve.edges == "wrap");
    CHECK(uncut.residents().front()->center().norm() > 12.0);
}

TEST_CASE("creatures as long as a small world live in it", "[preserve][edges]") {
    for (const char* bodies : {"ghostly", "solid"}) {
        ExperimentSettings settings = wrapped(bodies);
        settings.preserve.width = 5.0;
        settings.preserve.height = 5.0;
        settings.preserve.founders = 2;
        settings.preserve.energy_density = 1000.0;
        settings.preserve.walls = "-2.5 2.4 2.3 2.4";
        const auto preserve = begun(settings, {eel(3, 1.5, 0.25, 0.8), eater(1.0)});
        run_to(*preserve, 600);
        CHECK(preserve->total_energy() == preserve->founding_energy());
        CHECK(preserve->residents().size() >= 2);
    }
}

TEST_CASE("with ground, only the left and the right edge meet", "[preserve][edges][ground]") {
    ExperimentSettings settings = preserve_defaults(kinds(), true);
    settings.preserve.edges = "wrap";
    settings.preserve.bodies = "solid";
    settings.preserve.width = 12.0;
    settings.preserve.height = 8.0;
    settings.preserve.founders = 8;
    settings.preserve.energy_density = 200.0;
    settings.world.environment.gravity_direction = -45.0;
    settings.world.environment.friction = 0.3;
    const WorldArea area = area_of(settings.preserve, settings.world.environment);
    CHECK_FALSE(area.has_sides());
    CHECK(area.has_top());
    CHECK(area.nearest({7.0, 9.0, 0.0}) == Vec3(-5.0, 8.0, 0.0));
    const auto walker =
        load_creature(CAMBRIAN_SOURCE_DIR "/assets/creatures/walker.creature.json", kinds());
    REQUIRE(walker);
    const GenomePtr genome = walker->creature.individual->genome;
    check_same_on_any_threads(settings, {genome, eater(0.0)}, 300, 100);
    const auto preserve = begun(settings, {genome, eater(0.0)});
    run_to(*preserve, 900);
    CHECK(preserve->total_energy() == preserve->founding_energy());
    CHECK(std::any_of(preserve->residents().begin(), preserve->residents().end(),
                      [&](const auto& each) { return !area.contains(each->center()); }));
    for (const auto& each : preserve->residents()) {
        CHECK(each->bounds().low.y() > -0.05);
        CHECK(each->bounds().high.y() < 9.0);
    }
}

}  // namespace
}  // namespace cambrian
