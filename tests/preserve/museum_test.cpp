// The museum of a preserve.
#include "preserve/museum.h"

#include "support/build_speed.h"
#include "support/temporary_directory.h"
#include "worlds.h"

#include <algorithm>

namespace cambrian {
namespace {

using namespace test;

// A world in which grazers multiply.
ExperimentSettings fertile_world() {
    ExperimentSettings settings = small_world();
    settings.preserve.founders = 1;
    settings.preserve.restock = 0;
    settings.preserve.energy_density = 1000.0;
    settings.preserve.growth_time = 10.0;
    settings.preserve.max_population = 60;
    settings.mutation.rate = 0.0;
    settings.breeding.shares = {{"asexual", 1.0}, {"crossover", 0.0}, {"grafting", 0.0}};
    return settings;
}

TEST_CASE("the founder of a lineage with twenty living members comes into the museum once",
          "[preserve][museum]") {
    const auto preserve = begun(fertile_world(), {eater(0.0)});
    ThreadPool pool(1);
    std::vector<MuseumPiece> museum;
    for (int tick = 0; tick < 20'000 && museum.empty(); ++tick) {
        preserve->tick(pool);
        const Chronicle chronicle = preserve->take_chronicle();
        add_pieces(museum, chronicle.museum);
        for (const MuseumPiece& piece : chronicle.museum) {
            CHECK(piece.tick == preserve->ticks());
            CHECK(piece.count == kMembersForMuseum);
            CHECK(living_members(preserve->residents(), piece.number) >= kMembersForMuseum);
            CHECK(piece.genome != nullptr);
        }
    }
    REQUIRE(museum.size() == 1);
    CHECK(museum.front().reason == museum_reason::kLineage);
    MuseumPiece again = museum.front();
    again.tick += 100;
    add_pieces(museum, std::span(&again, 1));
    CHECK(museum.size() == 1);
    again.reason = museum_reason::kChildren;
    add_pieces(museum, std::span(&again, 1));
    CHECK(museum.size() == 2);
}

TEST_CASE("the parent of most living children comes into the museum every ten minutes",
          "[preserve][museum]") {
    ExperimentSettings settings = fertile_world();
    settings.preserve.max_population = by_build(10, 4);
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    KeptWorld world = kept_in(path, settings);
    Preserve& preserve = *world.preserve;
    CHECK(most_fertile(preserve.residents()) == nullptr);
    run_to(preserve, kTicksPerMuseumVisit);
    const Resident* parent = most_fertile(preserve.residents());
    REQUIRE(parent != nullptr);
    for (const auto& each : preserve.residents())
        CHECK(each->life.children <= parent->life.children);
    REQUIRE(world.file->write(preserve.take_chronicle(), preserve));
    const auto museum = load_museum(path, kinds());
    REQUIRE(museum);
    REQUIRE_FALSE(museum->empty());
    CHECK(museum->back().number == parent->life.number);
    CHECK(museum->back().tick == kTicksPerMuseumVisit);
    CHECK(museum->back().reason == museum_reason::kChildren);
    CHECK(museum->back().count == parent->life.children);
    CHECK(*museum->back().genome == *parent->genome());
    const auto earlier = folder.path() / "earlier.cambrian";
    world.file.reset();
    const auto saved = load_preserve(path, kinds());
    REQUIRE(saved);
    REQUIRE(saved->snapshots.size() > 1);
    REQUIRE(copy_preserve(path, saved->snapshots.front().tick, earlier, kinds()));
    const auto before = load_museum(earlier, kinds());
    REQUIRE(before);
    CHECK(std::ranges::none_of(
        *before, [](const MuseumPiece& piece) { return piece.tick == kTicksPerMuseumVisit; }));
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    CHECK(opened->museum.size() == museum->size());
}

}  // namespace
}  // namespace cambrian
