#include "studio/shortcuts.h"

#include "studio_fixture.h"

#include <GLFW/glfw3.h>

namespace cambrian {
namespace {

TEST_CASE("no two shortcuts share a key", "[studio][shortcuts]") {
    for (const auto all : {shortcuts(), picking_shortcuts()}) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j)
                CHECK_FALSE(all[i].press == all[j].press);
        }
    }
}

TEST_CASE("Space evolves, but not while text is typed", "[studio][shortcuts]") {
    const test::StudioFixture studio;
    Requests out;
    press_shortcut({GLFW_KEY_SPACE}, true, studio.frame(), out);
    CHECK(out.all().empty());
    press_shortcut({GLFW_KEY_SPACE}, false, studio.frame(), out);
    CHECK(test::was_asked<ToggleEvolution>(out));
}

TEST_CASE("Shift distinguishes redo from undo", "[studio][shortcuts]") {
    const test::StudioFixture studio;
    Requests out;
    press_shortcut({GLFW_KEY_Z, true, true}, false, studio.frame(), out);
    CHECK(test::was_asked<RedoEdit>(out));
    CHECK_FALSE(test::was_asked<UndoEdit>(out));
}

TEST_CASE("the speed keys step through the speeds and stop at the ends", "[studio][shortcuts]") {
    const test::StudioFixture studio;
    Requests out;
    press_shortcut({GLFW_KEY_RIGHT_BRACKET}, false, studio.frame(), out);
    CHECK(test::asked<ChangeView>(out).view.speed == 2.0);
    Requests slower;
    press_shortcut({GLFW_KEY_LEFT_BRACKET}, false, studio.frame(), slower);
    CHECK(test::asked<ChangeView>(slower).view.speed == 0.5);
}

TEST_CASE("over the grid Space picks the creature in focus", "[studio][shortcuts][picking]") {
    test::StudioFixture studio;
    studio.show_grid(9);
    studio.focus_cell(4);
    Requests out;
    press_shortcut({GLFW_KEY_SPACE}, false, studio.frame(), out);
    CHECK(test::asked_picking<TogglePick>(out).cell == 4);
    CHECK_FALSE(test::was_asked<ToggleEvolution>(out));
}

TEST_CASE("number keys pick cells that exist", "[studio][shortcuts][picking]") {
    test::StudioFixture studio;
    studio.show_grid(9);
    Requests out;
    press_shortcut({GLFW_KEY_9}, false, studio.frame(), out);
    CHECK(test::asked_picking<TogglePick>(out).cell == 8);
    CHECK(test::asked<FocusCell>(out).cell == 8);
    Requests beyond;
    press_shortcut({GLFW_KEY_EQUAL}, false, studio.frame(), beyond);
    CHECK(beyond.all().empty());
}

TEST_CASE("arrows move the focus and stop at the edges of the grid",
          "[studio][shortcuts][picking]") {
    test::StudioFixture studio;
    studio.show_grid(12);  // 4 by 3
    const auto after = [&](std::size_t from, int key) {
        studio.focus_cell(from);
        Requests out;
        press_shortcut({key}, false, studio.frame(), out);
        return out.all().empty() ? from : test::asked<FocusCell>(out).cell;
    };
    CHECK(after(0, GLFW_KEY_RIGHT) == 1);
    CHECK(after(3, GLFW_KEY_RIGHT) == 3);
    CHECK(after(4, GLFW_KEY_LEFT) == 4);
    CHECK(after(1, GLFW_KEY_DOWN) == 5);
    CHECK(after(9, GLFW_KEY_DOWN) == 9);
    CHECK(after(2, GLFW_KEY_UP) == 2);
}

TEST_CASE("Escape leads from one creature back to the grid", "[studio][shortcuts][picking]") {
    test::StudioFixture studio;
    studio.show_grid(9);
    studio.show_single();
    Requests out;
    press_shortcut({GLFW_KEY_ESCAPE}, false, studio.frame(), out);
    CHECK(test::was_asked<ShowGrid>(out));
}

}  // namespace
}  // namespace cambrian
