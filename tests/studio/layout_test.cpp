#include "studio/layout.h"

#include "studio/rect_checks.h"
#include "support/catch.h"
#include "support/null_imgui.h"

#include <array>

namespace cambrian {
namespace {

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}
std::array<Rect, 7> places(const Layout& l) {
    return {l.bar, l.experiment, l.viewport, l.transport, l.inspector, l.timeline, l.population};
}

TEST_CASE("panels fill the window without overlapping at every usual size", "[studio][layout]") {
    struct Size {
        float width, height, scale;
    };
    for (const Size size : {Size{1280, 720, 1}, Size{1920, 1080, 1}, Size{3840, 2160, 2},
                            Size{1280, 800, 0.8F}, Size{1280, 800, 2}}) {
        const auto all = places(divide_window(size.width, size.height, {}, size.scale));
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].width == 0) continue;  // hidden
            CHECK(test::inside(all[i], size.width, size.height));
            for (std::size_t j = 0; j < i; ++j)
                CHECK_FALSE(overlap(all[i], all[j]));
        }
    }
}

TEST_CASE("a line along the bottom takes its height from the panels above", "[studio][layout]") {
    const Layout layout = divide_window(1280, 720, {}, 1, true);
    CHECK(layout.foot.height == 28);
    CHECK(layout.foot.width == 1280);
    CHECK(layout.foot.y + layout.foot.height == 720);
    for (const Rect& place : places(layout)) {
        CHECK(test::inside(place, 1280, 720));
        CHECK_FALSE(overlap(place, layout.foot));
    }
    CHECK(divide_window(1280, 720, {}, 1).foot.height == 0);
}

TEST_CASE("the viewport keeps most of the room at 1280 by 720", "[studio][layout]") {
    const Layout layout = divide_window(1280, 720, {}, 1);
    CHECK(layout.viewport.width > 600);
    CHECK(layout.viewport.height > 380);
}

TEST_CASE("in a narrow window the left panel hides the right one", "[studio][layout]") {
    ViewState view;
    CHECK(is_narrow(1280, 2));
    CHECK_FALSE(is_narrow(1280, 1.5F));
    const Layout both = divide_window(1280, 800, view, 2);
    CHECK(both.experiment.width == 540);
    CHECK(both.inspector.width == 0);
    CHECK(both.viewport.width > 600);
    CHECK(both.viewport.height > 200);
    view.panels.left = false;
    CHECK(divide_window(1280, 800, view, 2).inspector.width == 520);
}

TEST_CASE("hidden panels give their room to the viewport", "[studio][layout]") {
    ViewState bare;
    bare.panels.left = bare.panels.right = bare.panels.bottom = false;
    const Layout layout = divide_window(1280, 720, bare, 1);
    CHECK(layout.viewport.width == 1280);
    CHECK(layout.experiment.width == 0);
    CHECK(layout.transport.y + layout.transport.height == 720);
}

TEST_CASE("dragging a gap makes its panel wider", "[studio][layout]") {
    NullImGui gui;
    ViewState view;
    const auto draw = [&] { drag_gaps(divide_window(1280, 720, view, 1), view); };
    const float before = divide_window(1280, 720, view, 1).experiment.width;
    gui.frame(draw);
    const float middle = gui.place("gap left").center().x;
    gui.move_to({middle, 300});
    gui.frame(draw);
    gui.press();
    gui.frame(draw);
    gui.move_to({middle + 40, 300});
    gui.frame(draw);
    CHECK(divide_window(1280, 720, view, 1).experiment.width == Approx(before + 40).margin(1.5));
}

TEST_CASE("no drag can make the viewport too small", "[studio][layout]") {
    ViewState greedy;
    greedy.panels.left_width = greedy.panels.right_width = greedy.panels.bottom_height = 3000;
    const Layout layout = divide_window(1280, 720, greedy, 1);
    CHECK(layout.viewport.width > 200);
    CHECK(layout.viewport.height > 200);
}

}  // namespace
}  // namespace cambrian
