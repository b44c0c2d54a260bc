// Preserves whose ground has a shape.
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "preserve/life/founders.h"
#include "support/build_speed.h"
#include "support/temporary_directory.h"
#include "worlds.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace cambrian {
namespace {

using namespace test;

ExperimentSettings hilly(const char* bodies = "ghostly", const char* edges = "walls") {
    ExperimentSettings settings = preserve_defaults(kinds(), true);
    settings.preserve.bodies = bodies;
    settings.preserve.edges = edges;
    settings.preserve.width = 40.0;
    settings.preserve.height = 8.0;
    settings.preserve.founders = 12;
    settings.preserve.energy_density = 100.0;
    settings.world.environment.terrain = {.kind = "hills", .height = 1.0, .spacing = 3.0};
    return settings;
}

std::vector<GenomePtr> hill_walkers() {
    std::vector<GenomePtr> genomes = {eater(0.0)};
    for (const char* name : {"walker", "crawler"}) {
        const std::filesystem::path folder = CAMBRIAN_SOURCE_DIR "/assets/creatures";
        const auto read = load_creature(folder / (std::string(name) + ".creature.json"), kinds());
        REQUIRE(read);
        genomes.push_back(read->creature.individual->genome);
    }
    return genomes;
}

// Returns the gap of a resident to its ground as a scene of its own sees it, in m.
double gap_of(const Resident& resident, const ExperimentSettings& settings) {
    const auto scene = scene_of(resident.phenotype(), creature_kinds(), settings);
    REQUIRE(scene);
    REQUIRE((*scene)->begin_at(resident.save().motion));
    return (*scene)->ground_gap();
}

void check_stands(const Resident& resident, const ExperimentSettings& settings) {
    const double gap = gap_of(resident, settings);
    CHECK(gap > 0.0);
    CHECK(gap <= kStartClearance + 1e-12);
}

std::string refused(const std::string& text) {
    const auto read = parse_settings(text, "land.toml", kinds(), SettingsUse::kPreserve);
    return read ? "" : read.error().message;
}

TEST_CASE("the ground of a world joins itself where its edges meet", "[preserve][terrain]") {
    for (const char* kind : {"slope", "rough", "hills", "stairs", "blocks", "hurdles", "drawn"}) {
        INFO(kind);
        ExperimentSettings settings = hilly("ghostly", "wrap");
        TerrainSettings& terrain = settings.world.environment.terrain;
        terrain = {.kind = kind, .height = 0.2, .spacing = 1.0};
        terrain.slope = 2.0;
        if (terrain.kind == "drawn") terrain.points = "-19 0.4; -3 0; 4 1; 4 0.2; 12 0.4";
        REQUIRE(check_preserve(settings, kinds()));
        const auto area = world_area(settings);
        REQUIRE(area);
        REQUIRE(area->ground);
        const double width = settings.preserve.width;
        std::set<double> heights;
        RandomStream random(stream_seed({5, static_cast<std::uint64_t>(Purpose::kTest)}));
        for (int i = 0; i < 500; ++i) {
            const double x = random.uniform(-20.0, 20.0);
            const double height = area->ground_at(x);
            heights.insert(height);
            for (const double rounds : {-3.0, -1.0, 1.0, 50.0})
                CHECK(area->ground_at(x + rounds * width) == Approx(height).margin(1e-9));
        }
        CHECK(heights.size() > 2);
        for (const double seam : {-20.0, 20.0, 60.0})
            CHECK(area->ground_at(seam - 1e-9) ==
                  Approx(area->ground_at(seam + 1e-9)).margin(1e-7));
        for (int number = -400; number < 400; ++number) {
            const GroundPiece left = area->ground->piece(number);
            const GroundPiece right = area->ground->piece(number + 1);
            CHECK(left.right() == Approx(right.left()).margin(1e-9));
            CHECK(left.length > 1e-3);
        }
    }
}

TEST_CASE("the ground follows from the seed of the world and the number of the ground",
          "[preserve][terrain]") {
    const auto heights = [](std::uint64_t seed, std::uint64_t number) {
        ExperimentSettings settings = hilly();
        settings.seed = seed;
        settings.world.environment.terrain.seed = number;
        const auto area = world_area(settings);
        REQUIRE(area);
        std::vector<double> all;
        for (double x = -20.0; x <= 20.0; x += 0.5)
            all.push_back(area->ground_at(x));
        return all;
    };
    CHECK(heights(1, 1) == heights(1, 1));
    CHECK(heights(1, 1) != heights(2, 1));
    CHECK(heights(1, 1) != heights(1, 2));
    const std::vector<double> hills = heights(3, 1);
    CHECK(*std::max_element(hills.begin(), hills.end()) > 0.6);
    CHECK(*std::max_element(hills.begin(), hills.end()) <= 1.0);
    CHECK(*std::min_element(hills.begin(), hills.end()) >= 0.0);
}

TEST_CASE("settings of ground with a shape are read, written and checked", "[preserve][terrain]") {
    const std::string land = "[environment]\nground = true\n";
    const auto read =
        parse_settings(land + "terrain = \"hills\"\nterrain-height = 0.7\nterrain-spacing = 3.0\n",
                       "land.toml", kinds(), SettingsUse::kPreserve);
    REQUIRE(read);
    CHECK(read->world.environment.terrain.kind == "hills");
    const std::string text = write_settings(*read, kinds(), SettingsUse::kPreserve);
    const auto again = parse_settings(text, "land.toml", kinds(), SettingsUse::kPreserve);
    REQUIRE(again);
    CHECK(again->world.environment == read->world.environment);
    CHECK(refused("[environment]\nground = false\nterrain = \"hills\"\n") ==
          "land.toml: [environment] terrain: there is no ground; set ground = true or terrain = "
          "\"flat\"");
    CHECK_THAT(refused(land + "terrain = \"gaps\"\n"),
               Catch::Contains("terrain") && Catch::Contains("hurdles, drawn"));
    CHECK_THAT(refused(land + "terrain-ladder = true\n"), Catch::Contains("terrain-ladder"));
    CHECK(refused(land + "terrain = \"hills\"\nterrain-spacing = 8\n") ==
          "land.toml: [environment] terrain-spacing: a world 40 m wide has 18.5 m of it on each "
          "side of its level middle; expected at most a third of that, found 8 m");
    CHECK_THAT(
        refused("[preserve]\nwidth = 6.0\n" + land + "terrain = \"slope\"\nterrain-pad = 3\n"),
        Catch::Contains("terrain-pad: expected less than half"));
    CHECK_THAT(
        refused("[preserve]\nheight = 8.0\n" + land + "terrain = \"slope\"\nterrain-slope = 45\n"),
        Catch::Contains("terrain: the ground is up to 18.50 m high in a world of 8 m"));
    CHECK_THAT(refused(land + "terrain = \"drawn\"\n"), Catch::Contains("terrain-points"));
    CHECK_THAT(refused(land + "terrain = \"drawn\"\nterrain-points = \"-3 0; 25 1\"\n"),
               Catch::Contains("point 2 is at x = 25 m, outside the world; expected [-20, 20]"));
    const std::string drawn = land + "terrain = \"drawn\"\nterrain-points = \"-3 0; 3 1\"\n";
    CHECK(refused(drawn).empty());
    CHECK_THAT(refused("[preserve]\nedges = \"wrap\"\n" + drawn),
               Catch::Contains("first point is at a height of 0 m and the last at 1 m"));
}

TEST_CASE("creatures begin standing on hills, stairs and blocks", "[preserve][terrain]") {
    for (const char* kind : {"hills", "stairs", "blocks"}) {
        INFO(kind);
        ExperimentSettings settings = hilly("solid", "wrap");
        settings.world.environment.terrain = {
            .kind = kind, .height = kind == std::string("hills") ? 1.0 : 0.1, .spacing = 1.0};
        const auto preserve = begun(settings, hill_walkers());
        REQUIRE(preserve->residents().size() == 12);
        std::set<double> feet;
        for (const auto& each : preserve->residents()) {
            check_stands(*each, settings);
            feet.insert(std::round(50.0 * each->bounds().low.y()));
        }
        CHECK(feet.size() > 2);
        REQUIRE(preserve->intervene(
            {.what = intervention::kAdd, .x = 17.3, .y = 0.0, .genome = hill_walkers().back()}));
        check_stands(*preserve->residents().back(), settings);
        const std::uint64_t moved = preserve->residents().front()->life.number;
        REQUIRE(preserve->intervene(
            {.what = intervention::kMove, .number = moved, .x = -5.0, .y = 6.0}));
        check_stands(*preserve->residents().front(), settings);
        ThreadPool pool(1);
        std::size_t born = 0;
        for (int tick = 0; tick < 1500 && born < 3; ++tick) {
            const std::uint64_t last = preserve->residents().back()->life.number;
            preserve->tick(pool);
            for (const auto& each : preserve->residents()) {
                if (each->life.number <= last) continue;
                ++born;
                check_stands(*each, settings);
            }
        }
        CHECK(born >= 3);
    }
}

TEST_CASE("food grows, falls and is given on the surface", "[preserve][terrain]") {
    for (const char* edges : {"walls", "wrap"}) {
        ExperimentSettings settings = hilly("ghostly", edges);
        settings.preserve.plant_height = 0.4;
        const auto preserve = begun(settings, hill_walkers());
        REQUIRE(preserve->intervene({.what = intervention::kFeed, .x = 1.0, .y = 6.0}));
        REQUIRE(preserve->intervene({.what = intervention::kRemove, .number = 1}));
        run_to(*preserve, 300);
        const WorldArea& area = preserve->area();
        double above = 0.0;
        std::set<double> heights;
        for (const Pellet& plant : preserve->plants().all()) {
            const double height = plant.y - area.ground_at(plant.x);
            CHECK(height >= -1e-12);
            CHECK(height <= 0.4 + 1e-12);
            above += height;
            heights.insert(std::round(5.0 * area.ground_at(plant.x)));
        }
        const auto count = static_cast<double>(preserve->plants().all().size());
        CHECK(above / count == Approx(0.2).margin(0.03));
        CHECK(heights.size() >= 4);
        REQUIRE_FALSE(preserve->flesh().all().empty());
        for (const Pellet& piece : preserve->flesh().all())
            CHECK(piece.y == area.ground_at(piece.x));
        CHECK(preserve->total_energy() == preserve->founding_energy());
    }
}

TEST_CASE("random creatures neither sink into the ground nor break on it", "[preserve][terrain]") {
    for (const char* kind : {"hills", "rough", "hurdles"}) {
        INFO(kind);
        ExperimentSettings settings = hilly("ghostly", "wrap");
        settings.preserve.founders = 20;
        if (kind != std::string("hills"))
            settings.world.environment.terrain = {.kind = kind, .height = 0.15, .spacing = 0.6};
        const auto founders = random_founders(settings, kinds());
        REQUIRE(founders);
        const auto preserve = begun(settings, *founders);
        ThreadPool pool(2);
        const std::uint64_t end = by_build(3600, 600);
        double deepest = 0.0;
        std::size_t broken = 0;
        while (preserve->ticks() < end) {
            preserve->tick(pool);
            for (const Life& life : preserve->take_chronicle().died)
                broken += life.cause == DeathCause::kBrokenPhysics ? 1 : 0;
            if (preserve->ticks() % 60 != 0) continue;
            REQUIRE(preserve->total_energy() == preserve->founding_energy());
            for (const auto& each : preserve->residents()) {
                for (const Rectangle& part : each->rectangles())
                    CHECK(part.center.y() > preserve->area().ground_at(part.center.x()));
                // Beside a hurdle, the height above the ground is no distance.
                if (kind != std::string("hurdles"))
                    deepest = std::min(deepest, gap_of(*each, settings));
            }
        }
        CHECK(deepest > -0.05);
        CHECK(broken == 0);
    }
}

TEST_CASE("threads do not change the bits of solid creatures on hills that meet",
          "[preserve][terrain][threads]") {
    ExperimentSettings settings = hilly("solid", "wrap");
    settings.preserve.founders = 16;
    check_same_on_any_threads(settings, hill_walkers(), 300, 30);
}

TEST_CASE("a world with hills goes on from its file with the same bits, and a replay repeats it",
          "[preserve][terrain]") {
    for (const char* bodies : {"ghostly", "solid"}) {
        const TemporaryDirectory folder;
        const auto path = folder.path() / "hills.cambrian";
        ExperimentSettings settings = hilly(bodies, "wrap");
        settings.preserve.walls = "3 0 3 1.5";
        KeptWorld world = kept_in(path, settings);
        Preserve& uncut = *world.preserve;
        run_to(uncut, 60);
        REQUIRE(uncut.intervene({.what = intervention::kFeed, .x = 1.0, .y = 1.0}));
        REQUIRE(uncut.intervene(law_change(changeable_laws(kinds()).front(), 60.0)));
        REQUIRE(uncut.intervene(
            {.what = intervention::kWall, .x = 19.0, .y = 2.0, .to_x = 21.0, .to_y = 2.0}));
        REQUIRE(uncut.intervene({.what = intervention::kRest}));
        REQUIRE(world.file->write(uncut.take_chronicle(), uncut));
        world.file.reset();
        repeated_from(path, world, 0);
        const auto opened = PreserveFile::open(path, kinds());
        REQUIRE(opened);
        CHECK(opened->origin.settings->world.environment == settings.world.environment);
        const auto resumed = Preserve::resume(opened->origin.settings, kinds(), world.founders,
                                              opened->state, opened->laws);
        REQUIRE(resumed);
        run_to(uncut, 400);
        run_to(**resumed, 400);
        CHECK(digest(**resumed) == digest(uncut));
    }
}

TEST_CASE("hills without height are a flat world, bit for bit", "[preserve][terrain]") {
    ExperimentSettings hills = hilly("solid");
    hills.world.environment.terrain.height = 0.0;
    ExperimentSettings flat = hills;
    flat.world.environment.terrain = {};
    const auto first = begun(hills, hill_walkers());
    const auto second = begun(flat, hill_walkers());
    CHECK(first->area().ground == nullptr);
    run_to(*first, 200);
    run_to(*second, 200);
    CHECK(digest(*first) == digest(*second));
}

TEST_CASE("walls of the settings stand on the ground, and none is built below it",
          "[preserve][terrain]") {
    ExperimentSettings settings = hilly();
    settings.world.environment.terrain = {.kind = "drawn", .points = "2 0; 4 1.2; 9 1.2; 12 -0.5"};
    settings.preserve.walls = "6 0 6 1";
    const auto preserve = begun(settings, hill_walkers());
    REQUIRE(preserve->walls().lines().size() == 1);
    CHECK(preserve->walls().lines().front().from.y() == Approx(1.2));
    CHECK(preserve->walls().lines().front().to.y() == Approx(2.2));
    CHECK(preserve->area().bottom() == -0.5);
    const auto below = preserve->intervene(
        {.what = intervention::kWall, .x = 6.0, .y = 0.0, .to_x = 8.0, .to_y = 0.9});
    REQUIRE_FALSE(below);
    CHECK(below.error().message == "This wall cannot be built: it is below the ground.");
    CHECK(preserve->intervene(
        {.what = intervention::kWall, .x = 15.0, .y = -0.4, .to_x = 15.0, .to_y = 1.0}));
}

TEST_CASE("whiskers and heights of the ground tell of hills and walls, and of nothing to the numb",
          "[preserve][terrain]") {
    ExperimentSettings settings = hilly("ghostly", "wrap");
    settings.world.environment.terrain = {.kind = "drawn", .points = "-6 0; -5 1; 5 1; 6 0"};
    const auto area = world_area(settings);
    REQUIRE(area);
    const DrawnWalls walls({{Vec3(19.0, 0.0, 0.0), Vec3(19.0, 2.0, 0.0)}}, area->torus());
    const auto reading = [&](const Environment& environment, const WorldArea& place, double x,
                             double y, const Vec3& way) {
        const CommonSenses common(place, environment, &walls);
        return CreatureSenses(common, 1).distance_to_ground({x, y, 0.0}, way, 1.0);
    };
    const Environment& land = settings.world.environment;
    CHECK(reading(land, *area, 0.0, 1.4, -Vec3::UnitY()) == Approx(0.4));
    CHECK(reading(land, *area, 40.0, 1.4, -Vec3::UnitY()) == Approx(0.4));
    CHECK(reading(land, *area, 10.0, 0.3, -Vec3::UnitY()) == Approx(0.3));
    CHECK(reading(land, *area, -21.5, 1.0, Vec3::UnitX()) == Approx(0.4));  // an image of the wall
    CHECK(reading(land, *area, 6.8, 0.5, -Vec3::UnitX()) > 1.0);
    CHECK(reading(land, *area, 6.3, 0.5, -Vec3::UnitX()) == Approx(0.8));
    Environment numb = land;
    numb.numb = true;
    CHECK(std::isinf(reading(numb, *area, 0.0, 1.4, -Vec3::UnitY())));
    const CommonSenses common(*area, land);
    CHECK(CreatureSenses(common, 1).ground_height(45.5) == Approx(0.5));
    CHECK(CommonSenses(*area, numb).ground_height(45.5) == 0.0);
    // Flat worlds have the bits that they always had.
    const WorldArea flat = area_of(settings.preserve, land);
    CHECK(std::isinf(reading(land, flat, 0.0, 0.4, -Vec3::UnitY())));
}

}  // namespace
}  // namespace cambrian
