#include "studio/shortcuts.h"

#include "studio_fixture.h"

#include <GLFW/glfw3.h>

namespace cambrian {
namespace {

TEST_CASE("no two shortcuts share a key", "[studio][shortcuts]") {
    const auto all = shortcuts();
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            CHECK_FALSE(all[i].press == all[j].press);
    }
}

TEST_CASE("Space evolves, but not while text is typed", "[studio][shortcuts]") {
    const test::StudioFixture studio;
    Requests out;
    press_shortcut({GLFW_KEY_SPACE}, true, studio.frame(), out);
    CHECK(out.actions().empty());
    press_shortcut({GLFW_KEY_SPACE}, false, studio.frame(), out);
    CHECK(test::was_asked<ToggleEvolution>(out));
}

TEST_CASE("Shift tells redo from undo", "[studio][shortcuts]") {
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

}  // namespace
}  // namespace cambrian
