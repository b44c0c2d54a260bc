#include "studio/main_window.h"

#include "studio_fixture.h"
#include "support/null_imgui.h"

namespace cambrian {
namespace {

// Frames of the whole window; it opens windows of its own.
void draw_whole(NullImGui& gui, MainWindow& window, const FrameContext& frame, Requests& out) {
    gui.frame([&] { window.draw(frame, 720, out); });
}

bool inside(const Rect& rect, float width, float height) {
    return rect.x >= 0 && rect.y >= 0 && rect.x + rect.width <= width &&
           rect.y + rect.height <= height;
}

TEST_CASE("the main controls stand inside a window of 1280 by 720", "[studio][main_window]") {
    NullImGui gui(1280, 720);
    MainWindow window(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    studio.finish_generation(1.0);
    Requests out;
    draw_whole(gui, window, studio.frame(), out);
    for (const char* name :
         {"File", "Evolve", "Step one generation", "goal.behavior", "Restart", "Play", "16×",
          "Newest", "Follow", "Fit", "Brain", "timeline", "tile 0"}) {
        INFO(name);
        CHECK(inside(gui.place(name), 1280, 720));
    }
    CHECK(out.actions().empty());
}

TEST_CASE("the timeline's and the population's controls stand in a small window without overlap",
          "[studio][main_window]") {
    NullImGui gui(1280, 720);
    MainWindow window(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    studio.finish_generation(1.0);
    Requests out;
    draw_whole(gui, window, studio.frame(), out);
    for (const char* name : {"timeline quantity", "Export", "tile order", "Starred"}) {
        INFO(name);
        CHECK(inside(gui.place(name), 1280, 720));
    }
    const Rect& quantity = gui.place("timeline quantity");
    CHECK(quantity.x + quantity.width < gui.place("Export").x);
    CHECK(gui.place("Export").x + gui.place("Export").width < gui.place("tile order").x);
    CHECK(gui.place("timeline").y > quantity.y + quantity.height);
}

TEST_CASE("the keyboard can be sent to the timeline and to the population",
          "[studio][main_window]") {
    NullImGui gui(1280, 720);
    MainWindow window(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    for (int i = 0; i < 5; ++i)
        studio.finish_generation(i);
    const auto left_in = [&](Place place) {
        FrameContext frame = studio.frame();
        Requests out;
        draw_whole(gui, window, frame, out);
        frame.focus = place;
        draw_whole(gui, window, frame, out);
        frame.focus = Place::kNone;
        gui.hold_key(ImGuiKey_LeftArrow, true);
        draw_whole(gui, window, frame, out);
        gui.hold_key(ImGuiKey_LeftArrow, false);
        draw_whole(gui, window, frame, out);
        return out;
    };
    const Requests timeline = left_in(Place::kTimeline);
    CHECK(test::asked<ShowChampion>(timeline).generation == 3);
    CHECK_FALSE(test::was_asked<ShowIndividual>(timeline));
    const Requests population = left_in(Place::kPopulation);
    CHECK(test::was_asked<ShowIndividual>(population));
    CHECK_FALSE(test::was_asked<ShowChampion>(population));
}

TEST_CASE("the transport's controls do not overlap in a small window", "[studio][main_window]") {
    NullImGui gui(1280, 720);
    MainWindow window(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    Requests out;
    draw_whole(gui, window, studio.frame(), out);
    const Rect& fastest = gui.place("16×");
    CHECK(fastest.x + fastest.width < gui.place("Newest").x);
}

TEST_CASE("a notice lies over the viewport and can be dismissed", "[studio][main_window]") {
    NullImGui gui(1280, 720);
    MainWindow window(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    const Notice notice{NoticeKind::kProblem, "The disk is full; free some room and save again."};
    FrameContext frame = studio.frame();
    frame.notice = &notice;
    Requests out;
    gui.click("Dismiss", [&] { window.draw(frame, 720, out); });
    CHECK(test::was_asked<DismissNotice>(out));
}

TEST_CASE("files lie over the panels and can be cancelled", "[studio][main_window]") {
    NullImGui gui(1280, 720);
    MainWindow window(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    studio.files().open = true;
    studio.files().opened = 1;
    Requests out;
    gui.click("Cancel", [&] { window.draw(studio.frame(), 720, out); });
    CHECK(test::was_asked<CloseFilePanel>(out));
}

TEST_CASE("in selection by hand the controls stand inside a window of 1280 by 720",
          "[studio][main_window][picking]") {
    NullImGui gui(1280, 720);
    MainWindow window(nullptr);
    test::StudioFixture studio;
    studio.show_grid(25);
    Requests out;
    draw_whole(gui, window, studio.frame(), out);
    for (const char* name :
         {"Automatic", "Hand-pick",    "Breed",   "cell 1",
          "cell 25",   "Back",         "Forward", "View",
          "Keep",      "Save…",        "Scores",  "Hints",
          "25",        "Wild",         "dial",    "Newcomers for the rest",
          "Assist",    "Inject picks", "New run", "Grid from the creature on show",
          "grid 1",    "shelf"}) {
        INFO(name);
        CHECK(inside(gui.place(name), 1280, 720));
    }
    CHECK(out.actions().empty());
}

TEST_CASE("a creature of the grid dragged to the shelf is kept", "[studio][main_window][picking]") {
    NullImGui gui(1280, 720);
    MainWindow window(nullptr);
    test::StudioFixture studio;
    studio.show_grid(9);
    Requests out;
    const auto draw = [&] { gui.bare_frame([&] { window.draw(studio.frame(), 720, out); }); };
    draw();
    gui.move_to(gui.place("cell 6").center());
    draw();
    gui.press();
    draw();
    gui.move_to(gui.place("shelf").center());
    draw();
    draw();
    gui.release();
    draw();
    CHECK(test::asked_desk<PinCreature>(out).cell == 5);
}

TEST_CASE("one creature of the grid has the viewport and leads back",
          "[studio][main_window][picking]") {
    NullImGui gui(1280, 720);
    MainWindow window(nullptr);
    test::StudioFixture studio;
    studio.show_crawler();
    studio.show_grid(9);
    studio.show_single();
    Requests out;
    const auto draw = [&] { gui.bare_frame([&] { window.draw(studio.frame(), 720, out); }); };
    draw();
    CHECK(gui.has("viewport"));
    CHECK_FALSE(gui.has("cell 1"));
    gui.move_to(gui.place("Back to the grid").center());
    draw();
    gui.press();
    draw();
    gui.release();
    draw();
    CHECK(test::was_asked<ShowGrid>(out));
}

}  // namespace
}  // namespace cambrian
