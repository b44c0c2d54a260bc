#include "genome/creature_name.h"
#include "panel_press.h"
#include "studio/panels/generations/population_panel.h"
#include "studio/viewer/origin_words.h"
#include "support/null_imgui.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr std::size_t kMany = 2000;

// Adds one generation of so many creatures, best first. Their other measures differ, in another
// order.
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

void show(test::StudioFixture& studio, const JudgedIndividual& creature) {
    REQUIRE(studio.playback().show(exhibit_of(creature, ExhibitSource::kPopulation)));
}

JudgedIndividual creature_at(test::StudioFixture& studio, std::size_t rank) {
    const JudgedIndividual& best = studio.snapshot().champions.back();
    return {best.generation, studio.snapshot().population.at(rank), best.settings};
}

struct PopulationRun : test::PanelRun<PopulationPanel> {
    PopulationRun(float width, float height, std::size_t count)
        : test::PanelRun<PopulationPanel>(width, height) {
        populate(studio, count);
    }
};

TEST_CASE("of two thousand creatures only the visible ones are drawn and expressed",
          "[studio][population]") {
    PopulationRun run(640, 180, kMany);
    for (int i = 0; i < 10; ++i)
        run.frame();
    CHECK(run.panel.tiles_drawn() >= 7);
    CHECK(run.panel.tiles_drawn() <= 24);
    CHECK(run.panel.bodies_kept() <= 24);
    const std::size_t in_sight = run.panel.bodies_kept();
    run.frame();
    CHECK(run.panel.bodies_kept() == in_sight);
}

TEST_CASE("scrolling through all tiles keeps few bodies in memory", "[studio][population]") {
    PopulationRun run(640, 180, kMany);
    run.frame();
    run.gui.move_to({300, 120});
    for (int i = 0; i < 400; ++i) {
        ImGui::GetIO().MouseWheel = -1.0F;
        run.frame();
        CHECK(run.panel.tiles_drawn() <= 24);
        CHECK(run.panel.bodies_kept() <= PhenotypeCache::kMostKept);
    }
    CHECK(run.panel.bodies_kept() == PhenotypeCache::kMostKept);
}

TEST_CASE("the creatures of a full window are expressed over several frames",
          "[studio][population]") {
    PopulationRun run(1280, 1600, kMany);
    std::size_t before = 0;
    for (int i = 0; i < 20; ++i) {
        run.frame();
        CHECK(run.panel.bodies_kept() <= before + 24);
        before = run.panel.bodies_kept();
    }
    CHECK(run.panel.tiles_drawn() > 200);
    CHECK(before == run.panel.tiles_drawn());
}

TEST_CASE("tiles are sorted by the chosen quantity", "[studio][population]") {
    test::StudioFixture studio;
    populate(studio, 50);
    const auto sorted_by = [&](TileOrder order, auto measure) {
        const std::vector<Tile> tiles = list_tiles(studio.snapshot(), studio.stars(), order, {});
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

TEST_CASE("sorted by difference the most unusual creature is first, and ranks do not change",
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
    const auto tiles = list_tiles(studio.snapshot(), studio.stars(), TileOrder::kDifference, {});
    CHECK(tiles.front().creature.individual == odd);
    CHECK(tiles.front().rank == 7);
    CHECK(tiles.front().key > tiles[1].key);
}

TEST_CASE("one tile per body plan shows the best creature of each", "[studio][population]") {
    test::StudioFixture studio;
    populate(studio, 9);
    std::vector<IndividualPtr>& population = studio.snapshot().population;
    for (std::size_t i = 0; i < population.size(); ++i) {
        auto planned = std::make_shared<Individual>(*population[i]);
        planned->result.plan = i / 3;
        population[i] = planned;
    }
    const auto tiles =
        list_tiles(studio.snapshot(), studio.stars(), TileOrder::kFitness, {.one_a_plan = true});
    REQUIRE(tiles.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(tiles[i].creature.individual == population[3 * i]);
        CHECK(tiles[i].rank == 3 * i + 1);
    }
}

TEST_CASE("a starred creature stays when its generation has passed", "[studio][population]") {
    test::StudioFixture studio;
    populate(studio, 20);
    const JudgedIndividual kept = creature_at(studio, 5);
    studio.stars().toggle(kept);
    auto tiles =
        list_tiles(studio.snapshot(), studio.stars(), TileOrder::kFitness, {.starred_only = true});
    REQUIRE(tiles.size() == 1);
    CHECK(tiles[0].rank == 6);
    studio.finish_generation(2.0);
    tiles =
        list_tiles(studio.snapshot(), studio.stars(), TileOrder::kFitness, {.starred_only = true});
    REQUIRE(tiles.size() == 1);
    CHECK(tiles[0].creature.individual == kept.individual);
    CHECK(tiles[0].creature.generation == 0);
    CHECK(tiles[0].rank == 0);
    CHECK(list_tiles(studio.snapshot(), studio.stars(), TileOrder::kFitness, {}).size() == 1);
}

TEST_CASE("a click on a tile's corner asks for its star, elsewhere for the creature",
          "[studio][population]") {
    PopulationRun run(640, 300, 20);
    const Requests star = run.click("star 2");
    CHECK(test::asked<ToggleStar>(star).creature.individual == run.studio.snapshot().population[2]);
    CHECK_FALSE(test::was_asked<ShowIndividual>(star));
    const Requests tile = run.click("tile 1");
    CHECK(test::asked<ShowIndividual>(tile).creature.individual ==
          run.studio.snapshot().population[1]);
    CHECK_FALSE(test::was_asked<ToggleStar>(tile));
}

TEST_CASE("the arrow keys move through the tiles in the order shown", "[studio][population]") {
    PopulationRun run(640, 180, 200);
    const auto shown_by = [&](ImGuiKey key) {
        return test::asked<ShowIndividual>(run.press_key(key)).creature.individual->uid;
    };
    CHECK(shown_by(ImGuiKey_RightArrow) == 1);  // none is displayed, so the first one is chosen
    show(run.studio, creature_at(run.studio, 0));
    CHECK(shown_by(ImGuiKey_RightArrow) == 2);
    CHECK(run.press_key(ImGuiKey_LeftArrow).all().empty());
    const std::uint64_t below = shown_by(ImGuiKey_DownArrow);
    CHECK(below > 4);
    show(run.studio, creature_at(run.studio, below - 1));
    CHECK(shown_by(ImGuiKey_UpArrow) == 1);
    show(run.studio, creature_at(run.studio, 199));
    CHECK(run.press_key(ImGuiKey_DownArrow).all().empty());
}

TEST_CASE("sorting and filter are chosen in the heading, and a removed star is restored there",
          "[studio][population]") {
    PopulationRun run(640, 300, 20);
    run.click("tile order");
    CHECK(test::asked<ChangeView>(run.click("by mass")).view.order == TileOrder::kMass);
    CHECK(test::asked<ChangeView>(run.click("One per body plan")).view.one_a_plan);
    CHECK(test::asked<ChangeView>(run.click("Starred")).view.starred_only);
    run.studio.view().starred_only = true;
    run.studio.stars().toggle(creature_at(run.studio, 0));
    run.studio.stars().toggle(creature_at(run.studio, 0));
    CHECK(test::was_asked<RestoreStar>(run.click("Give back")));
}

TEST_CASE("a creature's origin is described in words", "[studio][population]") {
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
    const std::string parent = creature_name(*studio.snapshot().population[2]->genome);
    CHECK(words.find("Born in generation 12\nCrossover, from " + parent +
                     " (rank 3) and abcdef01") == 0);
    CHECK(words.find("No-such-operator: part 2 length 0.4 → 0.5") != std::string::npos);
    CHECK(words.find("and 2 more mutations") != std::string::npos);
}

TEST_CASE("the list goes to its top when another run begins", "[studio][population]") {
    PopulationRun run(640, 180, 200);
    const auto scrolled = [&] {
        for (int i = 0; i < 4; ++i)
            run.frame();
        return !run.gui.has("tile 0") || run.gui.place("tile 0").y < 0.0F;
    };
    run.frame();
    show(run.studio, creature_at(run.studio, 150));
    run.press_key(ImGuiKey_DownArrow);
    run.gui.forget_places();
    REQUIRE(scrolled());
    ++run.studio.snapshot().experiment;
    run.gui.forget_places();
    CHECK_FALSE(scrolled());
}

}  // namespace
}  // namespace cambrian
