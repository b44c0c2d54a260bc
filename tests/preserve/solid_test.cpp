// Preserves with solid bodies.
#include "support/build_speed.h"
#include "worlds.h"

#include <algorithm>

namespace cambrian {
namespace {

using namespace test;

ExperimentSettings solid_world() {
    ExperimentSettings settings = small_world();
    settings.preserve.bodies = "solid";
    return settings;
}

// A solid world in which creatures meet all the time.
ExperimentSettings narrow_world() {
    ExperimentSettings settings = solid_world();
    settings.preserve.width = 6.0;
    settings.preserve.height = 6.0;
    settings.preserve.energy_density = 300.0;
    settings.preserve.founders = 12;
    return settings;
}

TEST_CASE("energy is constant to the last unit among solid creatures", "[preserve][solid]") {
    ExperimentSettings settings = solid_world();
    settings.preserve.founders = 16;
    const auto preserve = begun(settings, {eater(0.0), eater(1.0), fish(kind_catalog())});
    ThreadPool pool(1);
    std::size_t births = 0;
    std::size_t broken = 0;
    const int ticks = by_build(4000, 2000);
    for (int tick = 0; tick < ticks; ++tick) {
        preserve->tick(pool);
        REQUIRE(preserve->total_energy() == preserve->founding_energy());
        const Chronicle chronicle = preserve->take_chronicle();
        births += chronicle.born.size();
        broken += static_cast<std::size_t>(std::count_if(
            chronicle.died.begin(), chronicle.died.end(),
            [](const Life& life) { return life.cause == DeathCause::kBrokenPhysics; }));
    }
    CHECK(births > 16);
    CHECK(broken == 0);
    CHECK(preserve->solid_counts().joined_ticks > 100);
}

TEST_CASE("solid creatures are added and moved to the nearest room", "[preserve][solid]") {
    ExperimentSettings settings = solid_world();
    settings.preserve.founders = 2;
    const auto preserve = begun(settings, {fish(kind_catalog())});
    const Vec3 taken = preserve->residents().front()->center();
    REQUIRE(preserve->intervene({.what = intervention::kAdd,
                                 .x = taken.x(),
                                 .y = taken.y(),
                                 .genome = fish(kind_catalog())}));
    REQUIRE(preserve->intervene({.what = intervention::kMove,
                                 .number = preserve->residents()[1]->life.number,
                                 .x = taken.x(),
                                 .y = taken.y()}));
    const auto& residents = preserve->residents();
    REQUIRE(residents.size() == 3);
    for (std::size_t a = 0; a < residents.size(); ++a) {
        for (std::size_t b = a + 1; b < residents.size(); ++b)
            CHECK_FALSE(overlap(residents[a]->bounds(), residents[b]->bounds()));
    }
    for (const auto& each : residents)
        CHECK((each->center() - taken).norm() < 8.0 * each->radius());
}

TEST_CASE("solid creatures do not overlap", "[preserve][solid]") {
    ExperimentSettings settings = solid_world();
    settings.preserve.width = 6.0;
    settings.preserve.height = 6.0;
    settings.preserve.energy_density = 900.0;
    settings.preserve.founders = 12;
    settings.preserve.bite_power = 0.0;
    const auto preserve = begun(settings, {fish(kind_catalog()), eater(0.0)});
    ThreadPool pool(1);
    int overlaps = 0;
    for (int tick = 0; tick < 900; ++tick) {
        preserve->tick(pool);
        const auto& residents = preserve->residents();
        for (std::size_t a = 0; a < residents.size(); ++a) {
            for (std::size_t b = a + 1; b < residents.size(); ++b) {
                for (Rectangle part : residents[a]->rectangles()) {
                    part.half_length -= 0.02;
                    part.half_width -= 0.02;
                    for (const Rectangle& other : residents[b]->rectangles())
                        overlaps += overlap(part, other) ? 1 : 0;
                }
            }
        }
    }
    CHECK(overlaps == 0);
    CHECK(preserve->solid_counts().joined_ticks > 500);
}

TEST_CASE("a solid hunter bites what its mouth touches", "[preserve][solid]") {
    const auto preserve = begun(narrow_world(), {eater(1.0, 0.4), eater(0.0), eater(0.0)});
    ThreadPool pool(1);
    Energy bitten = 0;
    for (int tick = 0; tick < 3600; ++tick) {
        preserve->tick(pool);
        for (const Life& life : preserve->take_chronicle().died)
            bitten += life.bitten;
    }
    for (const auto& each : preserve->residents())
        bitten += each->life.bitten;
    CHECK(bitten > energy_of(1.0));
}

TEST_CASE("with ramming a mouth takes energy in proportion to what its impacts took",
          "[preserve][solid]") {
    ExperimentSettings settings = narrow_world();
    settings.preserve.bite_power = 0.0;
    settings.preserve.ramming = 50.0;
    const auto preserve = begun(settings, {eater(1.0, 0.4), eater(0.0), eater(0.0)});
    ThreadPool pool(1);
    Energy taken = 0;
    double allowed = 0.0;  // J
    const auto lost_of_all = [&] {
        Energy sum = 0;
        for (const auto& each : preserve->residents())
            sum += each->life.lost;
        return sum;
    };
    for (int tick = 0; tick < 2400; ++tick) {
        const Energy before = lost_of_all();
        preserve->tick(pool);
        REQUIRE(preserve->total_energy() == preserve->founding_energy());
        Chronicle chronicle = preserve->take_chronicle();
        Energy after = lost_of_all();
        for (const Life& life : chronicle.died)
            after += life.lost;
        if (chronicle.died.empty()) {
            for (const auto& each : preserve->residents()) {
                for (const SceneImpact& impact : each->impacts())
                    allowed += 50.0 * std::max(impact.lost, 0.0);
            }
            taken += after - before;
        }
    }
    CHECK(taken > energy_of(1e-3));
    CHECK(joules(taken) <= allowed);
}

TEST_CASE("without ramming or the power to bite nobody loses energy to mouths",
          "[preserve][solid]") {
    ExperimentSettings settings = narrow_world();
    settings.preserve.bite_power = 0.0;
    const auto preserve = begun(settings, {eater(1.0, 0.4), eater(0.0), eater(0.0)});
    run_to(*preserve, 600);
    CHECK(preserve->solid_counts().joined_ticks > 100);
    for (const auto& each : preserve->residents())
        CHECK(each->life.lost == 0);
}

TEST_CASE("two solid creatures far apart move exactly as each in a trial of its own",
          "[preserve][solid]") {
    ExperimentSettings settings = solid_world();
    settings.preserve.width = 60.0;
    settings.preserve.height = 60.0;
    settings.preserve.founders = 2;
    settings.preserve.max_population = 2;
    settings.preserve.restock = 0;
    settings.preserve.energy_density = 10.0;
    const std::vector<GenomePtr> founders = {fish(kind_catalog()), eater(0.0)};
    const auto preserve = begun(settings, founders);
    const auto& residents = preserve->residents();
    REQUIRE(residents.size() == 2);
    REQUIRE((residents[0]->center() - residents[1]->center()).norm() > 5.0);
    check_moved_as_alone(*preserve, settings, founders);
    CHECK(preserve->solid_counts().joined_ticks == 0);
}

TEST_CASE("threads do not change the bits of solid creatures", "[preserve][solid][threads]") {
    ExperimentSettings settings = solid_world();
    settings.preserve.founders = 30;
    settings.preserve.energy_density = 200.0;
    check_same_on_any_threads(settings, {fish(kind_catalog()), eater(0.5)}, 600, 500);
}

TEST_CASE("solid creatures that go on from a snapshot have the bits of those that never stopped",
          "[preserve][solid]") {
    ExperimentSettings settings = solid_world();
    const std::vector<GenomePtr> founders = {eater(0.0), eater(1.0), fish(kind_catalog())};
    const auto uncut = begun(settings, founders);
    const std::uint64_t end = kTicksPerSnapshot + by_build<std::uint64_t>(900, 300);
    run_to(*uncut, kTicksPerSnapshot);
    const auto snapshot = uncut->take_chronicle().snapshot;
    REQUIRE(snapshot);
    run_to(*uncut, end);
    const auto resumed = Preserve::resume(std::make_shared<const ExperimentSettings>(settings),
                                          kinds(), founders, *snapshot);
    REQUIRE(resumed);
    run_to(**resumed, end);
    CHECK((*resumed)->solid_counts().joined_ticks > 100);
    CHECK(digest(**resumed) == digest(*uncut));
}

}  // namespace
}  // namespace cambrian
