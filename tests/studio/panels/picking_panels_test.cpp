#include "panel_press.h"
#include "studio/panels/bar/evolve_bar.h"
#include "studio/panels/picking/picking_grid_panel.h"
#include "studio/panels/picking/picking_panel.h"
#include "studio/panels/picking/picking_strip.h"
#include "studio/panels/picking/picking_tree_panel.h"
#include "studio/panels/picking/shelf_panel.h"
#include "support/null_imgui.h"

namespace cambrian {
namespace {

using test::click;

TEST_CASE("a click on a cell picks in the displayed grid", "[studio][picking]") {
    NullImGui gui;
    PickingGridPanel panel(nullptr);
    test::StudioFixture studio;
    studio.show_grid(12);
    studio.show_grid(12, GridOrigin::kBreeding);
    gui.move_to({5, 5});
    const Requests out = click(gui, panel, studio, "cell 7");
    CHECK(test::asked_picking<TogglePick>(out).node == 1);
    CHECK(test::asked_picking<TogglePick>(out).cell == 6);
    CHECK(test::asked<FocusCell>(out).cell == 6);
}

TEST_CASE("a double click shows the creature and leaves the picks as they were",
          "[studio][picking]") {
    NullImGui gui;
    PickingGridPanel panel(nullptr);
    test::StudioFixture studio;
    studio.show_grid(12);
    Requests out;
    const auto draw = [&] { panel.draw(studio.frame(), out); };
    gui.click("cell 3", draw);
    gui.press();
    gui.frame(draw);
    CHECK(test::asked<ShowCell>(out).cell == 2);
    int toggles = 0;
    for (const StudioRequest& request : out.all())
        toggles += test::request_if<AskPicking>(request) != nullptr ? 1 : 0;
    CHECK(toggles == 2);
}

TEST_CASE("the cells of every size of grid fill their place side by side", "[studio][picking]") {
    for (const int cells : kGridSizes) {
        NullImGui gui;
        PickingGridPanel panel(nullptr);
        test::StudioFixture studio;
        studio.show_grid(static_cast<std::size_t>(cells));
        Requests out;
        gui.frame([&] { panel.draw(studio.frame(), out); });
        const Rect& first = gui.place("cell 1");
        const Rect& second = gui.place("cell 2");
        const Rect& last = gui.place("cell " + std::to_string(cells));
        CHECK(second.x >= first.x + first.width);
        CHECK(last.x + last.width <= 1280.0F);
        CHECK(last.x + last.width > 1240.0F);
        CHECK(last.y + last.height <= 800.0F);
    }
}

TEST_CASE("the bar breeds once something is picked", "[studio][picking][evolve_bar]") {
    NullImGui gui;
    EvolveBar bar;
    test::StudioFixture studio;
    studio.show_grid(12);
    CHECK(click(gui, bar, studio, "Breed").all().empty());
    studio.picking().picks = {3};
    test::asked_picking<BreedPicks>(click(gui, bar, studio, "Breed"));
    studio.picking().status = PickingStatus::kBreeding;
    test::asked_picking<CancelDecision>(click(gui, bar, studio, "Stop"));
}

TEST_CASE("the bar switches between automatic evolution and selection by hand",
          "[studio][picking][evolve_bar]") {
    NullImGui gui;
    EvolveBar bar;
    test::StudioFixture studio;
    CHECK(click(gui, bar, studio, "Automatic").all().empty());
    CHECK(test::was_asked<ToggleHandPicking>(click(gui, bar, studio, "Hand-pick")));
    studio.show_grid(12);
    CHECK(test::was_asked<ToggleHandPicking>(click(gui, bar, studio, "Automatic")));
}

TEST_CASE("the strip offers to go back only if there is a grid before", "[studio][picking]") {
    NullImGui gui;
    PickingStrip strip;
    test::StudioFixture studio;
    studio.show_grid(12);
    CHECK(click(gui, strip, studio, "Back").all().empty());
    studio.show_grid(12, GridOrigin::kBreeding);
    test::asked_picking<GoBack>(click(gui, strip, studio, "Back"));
    CHECK(click(gui, strip, studio, "Forward").all().empty());
}

TEST_CASE("the strip acts on the creature in focus", "[studio][picking]") {
    NullImGui gui;
    PickingStrip strip;
    test::StudioFixture studio;
    studio.show_grid(12);
    studio.focus_cell(5);
    CHECK(test::asked<ShowCell>(click(gui, strip, studio, "View")).cell == 5);
    CHECK(test::asked<SaveCell>(click(gui, strip, studio, "Save…")).cell == 5);
    CHECK(test::asked_picking<PinCreature>(click(gui, strip, studio, "Keep")).cell == 5);
    const Requests hints = click(gui, strip, studio, "Hints");
    CHECK(test::asked<ChangePickingOptions>(hints).options.hints);
}

TEST_CASE("the panel changes how the next grid is bred", "[studio][picking]") {
    NullImGui gui;
    PickingPanel panel;
    test::StudioFixture studio;
    studio.show_grid(12);
    CHECK(test::asked_picking<ChangeGrid>(click(gui, panel, studio, "25")).grid.cells == 25);
    CHECK(test::asked_picking<ChangeGrid>(click(gui, panel, studio, "Wild")).grid.boldness ==
          Boldness::kWild);
    const double weight =
        test::asked_picking<ChangeGrid>(click(gui, panel, studio, "dial")).grid.fitness_weight;
    CHECK(weight == Approx(0.5).margin(0.1));
    test::asked_picking<ReplaceUnpicked>(
        click(gui, panel, studio, "Random creatures for the rest"));
}

TEST_CASE("assistance and the return to automatic evolution need picks", "[studio][picking]") {
    NullImGui gui;
    PickingPanel panel;
    test::StudioFixture studio;
    studio.show_grid(12);
    for (const char* name : {"Assist", "Inject picks", "New run"})
        CHECK(click(gui, panel, studio, name).all().empty());
    studio.picking().picks = {1, 2};
    CHECK(test::asked_picking<AskEvolution>(click(gui, panel, studio, "Assist")).generations == 10);
    CHECK(test::asked<HandOverPicks>(click(gui, panel, studio, "Inject picks")).use ==
          PicksUse::kInject);
    CHECK(test::asked<HandOverPicks>(click(gui, panel, studio, "New run")).use == PicksUse::kFound);
    CHECK(test::asked<ChangePickingOptions>(click(gui, panel, studio, "×25"))
              .options.assisted_generations == 25);
}

TEST_CASE("evolution from the picks can be cancelled", "[studio][picking]") {
    NullImGui gui;
    PickingPanel panel;
    test::StudioFixture studio;
    studio.show_grid(12);
    studio.picking().status = PickingStatus::kEvolving;
    test::asked_picking<CancelDecision>(click(gui, panel, studio, "Cancel"));
}

TEST_CASE("a click on the map visits that grid", "[studio][picking]") {
    NullImGui gui;
    PickingTreePanel panel;
    test::StudioFixture studio;
    studio.show_grid(4);
    studio.show_grid(4, GridOrigin::kBreeding);
    CHECK(test::asked_picking<VisitGrid>(click(gui, panel, studio, "grid 1")).node == 0);
}

TEST_CASE("a creature of the shelf can be put into the cell in focus or removed",
          "[studio][picking]") {
    NullImGui gui;
    ShelfPanel panel;
    test::StudioFixture studio;
    studio.show_grid(9);
    studio.focus_cell(7);
    studio.picking().shelf.push_back(studio.picking().tree.current().cell(1));
    CHECK(test::asked_picking<PlacePinned>(click(gui, panel, studio, "pin 1")).cell == 7);
    CHECK(test::asked_picking<UnpinCreature>(click(gui, panel, studio, "pin 1", 1)).place == 0);
}

}  // namespace
}  // namespace cambrian
