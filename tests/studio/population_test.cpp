#include "panel_press.h"
#include "studio/origin_words.h"
#include "studio/panels/population_panel.h"
#include "support/null_imgui.h"

#include <algorithm>

namespace cambrian {
namespace {

using test::click;
using test::press_key;

constexpr std::size_t kMany = 2000;

// So many creatures of one generation, best first; measures differ and grow otherwise than fitness.
void populate(test::StudioFixture& studio, std::size_t count) {
    studio.finish_generation(1.0);
    std::vector<IndividualPtr>& population = studio.snapshot().population;
    const GenomePtr original = population.front()->genome;
    population.clear();
    for (std::size_t i = 0; i < count; ++i) {
        auto individual = std::make_shared<Individual>();
        individual->genome = std::make_shared<const Genome>(*original);
        individual->uid = i + 1;
        individual->born = static_cast<std::uint32_t>((i * 7) % count);
        individual->evaluated = true;
        individual->result.fitness = static_cast<double>(count - i);
        individual->result.parts = static_cast<int>((i * 3) % 11);
        individual->result.mass = static_cast<double>((i * 13) % count);
        population.push_back(individual);
    }
}

void show(test::StudioFixture& studio, const ChampionRecord& creature) {
    REQUIRE(studio.playback().show(exhibit_of(*creature.individual, *creature.settings,
                                              creature.generation, ExhibitSource::kPopulation)));
}

ChampionRecord creature_at(test::StudioFixture& studio, std::size_t rank) {
    const ChampionRecord& best = studio.snapshot().champions.back();
    return {best.generation, studio.snapshot().population.at(rank), best.settings};
}

TEST_CASE("of two thousand creatures only those in sight are drawn and grown",
          "[studio][population]") {
    NullImGui gui(640, 180);
    PopulationPanel panel;
    test::StudioFixture studio;
    populate(studio, kMany);
    Requests out;
    const auto draw = [&] { panel.draw(studio.frame(), out); };
    for (int i = 0; i < 10; ++i)
        gui.frame(draw);
    CHECK(panel.tiles_drawn() >= 7);
    CHECK(panel.tiles_drawn() <= 24);
    CHECK(panel.bodies_kept() <= 24);
    const std::size_t in_sight = panel.bodies_kept();
    gui.frame(draw);
    CHECK(panel.bodies_kept() == in_sight);
}

TEST_CASE("however far the tiles are scrolled, few bodies are kept", "[studio][population]") {
    NullImGui gui(640, 180);
    PopulationPanel panel;
    test::StudioFixture studio;
    populate(studio, kMany);
    Requests out;
    const auto draw = [&] { panel.draw(studio.frame(), out); };
    gui.frame(draw);
    gui.move_to({300, 120});
    for (int i = 0; i < 400; ++i) {
        ImGui::GetIO().MouseWheel = -1.0F;
        gui.frame(draw);
        CHECK(panel.tiles_drawn() <= 24);
        CHECK(panel.bodies_kept() <= PhenotypeCache::kMostKept);
    }
    CHECK(panel.bodies_kept() == PhenotypeCache::kMostKept);
}

TEST_CASE("a window full of new creatures is grown over several frames", "[studio][population]") {
    NullImGui gui(1280, 1600);
    PopulationPanel panel;
    test::StudioFixture studio;
    populate(studio, kMany);
    Requests out;
    const auto draw = [&] { panel.draw(studio.frame(), out); };
    std::size_t before = 0;
    for (int i = 0; i < 20; ++i) {
        gui.frame(draw);
        CHECK(panel.bodies_kept() <= before + 24);
        before = panel.bodies_kept();
    }
    CHECK(panel.tiles_drawn() > 200);
    CHECK(before == panel.tiles_drawn());
}

TEST_CASE("tiles are sorted by what is asked for", "[studio][population]") {
    test::StudioFixture studio;
    populate(studio, 50);
    const auto sorted_by = [&](TileOrder order, auto measure) {
        const std::vector<Tile> tiles = list_tiles(studio.snapshot(), studio.stars(), order, false);
        REQUIRE(tiles.size() == 50);
        return std::is_sorted(tiles.begin(), tiles.end(), [&](const Tile& a, const Tile& b) {
            return measure(*a.creature.individual) > measure(*b.creature.individual);
        });
    };
    using One = const Individual&;
    CHECK(sorted_by(TileOrder::kFitness, [](One one) { return one.result.fitness; }));
    CHECK(sorted_by(TileOrder::kAge, [](One one) { return -static_cast<double>(one.born); }));
    CHECK(sorted_by(TileOrder::kParts, [](One one) { return one.result.parts; }));
    CHECK(sorted_by(TileOrder::kMass, [](One one) { return one.result.mass; }));
}

TEST_CASE("the creature least like the others comes first by difference, ranks stay",
          "[studio][population]") {
    test::StudioFixture studio;
    populate(studio, 9);
    std::vector<IndividualPtr>& population = studio.snapshot().population;
    for (IndividualPtr& each : population) {
        auto alike = std::make_shared<Individual>(*each);
        alike->result.parts = 4;
        alike->result.mass = 2.0;
        each = alike;
    }
    auto odd = std::make_shared<Individual>(*population[6]);
    odd->result.parts = 12;
    population[6] = odd;
    const auto tiles = list_tiles(studio.snapshot(), studio.stars(), TileOrder::kDifference, false);
    CHECK(tiles.front().creature.individual == odd);
    CHECK(tiles.front().rank == 7);
    CHECK(tiles.front().key > tiles[1].key);
}

TEST_CASE("a starred creature stays when its generation has passed", "[studio][population]") {
    test::StudioFixture studio;
    populate(studio, 20);
    const ChampionRecord kept = creature_at(studio, 5);
    studio.stars().toggle(kept);
    auto tiles = list_tiles(studio.snapshot(), studio.stars(), TileOrder::kFitness, true);
    REQUIRE(tiles.size() == 1);
    CHECK(tiles[0].rank == 6);
    studio.finish_generation(2.0);
    tiles = list_tiles(studio.snapshot(), studio.stars(), TileOrder::kFitness, true);
    REQUIRE(tiles.size() == 1);
    CHECK(tiles[0].creature.individual == kept.individual);
    CHECK(tiles[0].creature.generation == 0);
    CHECK(tiles[0].rank == 0);
    CHECK(list_tiles(studio.snapshot(), studio.stars(), TileOrder::kFitness, false).size() == 1);
}

TEST_CASE("a click on a tile's corner asks for its star, elsewhere for the creature",
          "[studio][population]") {
    NullImGui gui(640, 300);
    PopulationPanel panel;
    test::StudioFixture studio;
    populate(studio, 20);
    const Requests star = click(gui, panel, studio, "star 2");
    CHECK(test::asked<ToggleStar>(star).creature.individual == studio.snapshot().population[2]);
    CHECK_FALSE(test::was_asked<ShowIndividual>(star));
    const Requests tile = click(gui, panel, studio, "tile 1");
    CHECK(test::asked<ShowIndividual>(tile).creature.individual == studio.snapshot().population[1]);
    CHECK_FALSE(test::was_asked<ToggleStar>(tile));
}

TEST_CASE("the arrow keys move through the tiles in the order shown", "[studio][population]") {
    NullImGui gui(640, 180);
    PopulationPanel panel;
    test::StudioFixture studio;
    populate(studio, 200);
    const auto shown_by = [&](ImGuiKey key) {
        return test::asked<ShowIndividual>(press_key(gui, panel, studio, key))
            .creature.individual->uid;
    };
    CHECK(shown_by(ImGuiKey_RightArrow) == 1);  // none on show: the first
    show(studio, creature_at(studio, 0));
    CHECK(shown_by(ImGuiKey_RightArrow) == 2);
    CHECK(press_key(gui, panel, studio, ImGuiKey_LeftArrow).actions().empty());
    const std::uint64_t below = shown_by(ImGuiKey_DownArrow);
    CHECK(below > 4);
    show(studio, creature_at(studio, below - 1));
    CHECK(shown_by(ImGuiKey_UpArrow) == 1);
    show(studio, creature_at(studio, 199));
    CHECK(press_key(gui, panel, studio, ImGuiKey_DownArrow).actions().empty());
}

TEST_CASE("sorting and the filter are chosen in the heading, a taken star is given back there",
          "[studio][population]") {
    NullImGui gui(640, 300);
    PopulationPanel panel;
    test::StudioFixture studio;
    populate(studio, 20);
    click(gui, panel, studio, "tile order");
    CHECK(test::asked<ChangeView>(click(gui, panel, studio, "by mass")).view.order ==
          TileOrder::kMass);
    CHECK(test::asked<ChangeView>(click(gui, panel, studio, "Starred")).view.starred_only);
    studio.view().starred_only = true;
    studio.stars().toggle(creature_at(studio, 0));
    studio.stars().toggle(creature_at(studio, 0));
    CHECK(test::was_asked<RestoreStar>(click(gui, panel, studio, "Give back")));
}

TEST_CASE("a creature's origin is told in words", "[studio][population]") {
    test::StudioFixture studio;
    populate(studio, 5);
    Individual child;
    child.born = 12;
    child.method = "crossover";
    child.parents = {3, 0xabcdef0123456789};
    for (int i = 0; i < 8; ++i)
        child.mutations.push_back({"no-such-operator", "part 2 length", "0.4", "0.5"});
    const std::string words =
        origin_words(child, studio.snapshot().population, studio.frame().kinds);
    CHECK(words.find("Born in generation 12\nCrossover, from rank 3 and abcdef01") == 0);
    CHECK(words.find("No-such-operator: part 2 length 0.4 → 0.5") != std::string::npos);
    CHECK(words.find("and 2 more mutations") != std::string::npos);
}

}  // namespace
}  // namespace cambrian
