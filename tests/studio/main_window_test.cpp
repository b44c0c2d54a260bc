#include "studio/main_window.h"

#include "studio/panels/builtin_panels.h"
#include "studio/rect_checks.h"
#include "studio_fixture.h"
#include "support/null_imgui.h"

#include <array>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

// The main window with the crawler displayed.
struct WindowRun {
    NullImGui gui{1280, 720};
    MainWindow window{builtin_panels(), nullptr};
    test::StudioFixture studio;
    Requests out;

    WindowRun() { studio.show_crawler(); }

    void draw(const FrameContext& frame) {
        gui.bare_frame([&] { window.draw(frame, out); });
    }
    void draw() { draw(studio.frame()); }
    // Clicks a control that the last frame drew.
    void click(const std::string& name, const FrameContext& frame) {
        gui.move_to(gui.place(name).center());
        draw(frame);
        gui.press();
        draw(frame);
        gui.release();
        draw(frame);
    }
};

TEST_CASE("the main controls are inside a window of 1280 by 720", "[studio][main_window]") {
    WindowRun run;
    run.studio.finish_generation(1.0);
    run.draw();
    for (const char* name :
         {"File", "Evolve", "Step one generation", "goal.behavior", "Restart", "Play", "16×",
          "Newest", "Follow", "Fit", "Brain", "timeline", "tile 0"}) {
        INFO(name);
        CHECK(test::inside(run.gui.place(name), 1280, 720));
    }
    CHECK(run.out.all().empty());
}

TEST_CASE("the controls of timeline and population do not overlap in a small window",
          "[studio][main_window]") {
    WindowRun run;
    run.studio.finish_generation(1.0);
    run.draw();
    for (const char* name : {"timeline quantity", "Export", "tile order", "Starred"}) {
        INFO(name);
        CHECK(test::inside(run.gui.place(name), 1280, 720));
    }
    const Rect& quantity = run.gui.place("timeline quantity");
    CHECK(quantity.x + quantity.width < run.gui.place("Export").x);
    CHECK(run.gui.place("Export").x + run.gui.place("Export").width <
          run.gui.place("tile order").x);
    CHECK(run.gui.place("timeline").y > quantity.y + quantity.height);
}

TEST_CASE("the keyboard focus can be moved to the timeline and to the population",
          "[studio][main_window]") {
    WindowRun run;
    for (int i = 0; i < 5; ++i)
        run.studio.finish_generation(i);
    const auto left_in = [&](Place place) {
        FrameContext frame = run.studio.frame();
        run.draw(frame);
        frame.window.focus = place;
        run.draw(frame);
        frame.window.focus = Place::kNone;
        run.gui.hold_key(ImGuiKey_LeftArrow, true);
        run.draw(frame);
        run.gui.hold_key(ImGuiKey_LeftArrow, false);
        run.draw(frame);
        return std::exchange(run.out, {});
    };
    const Requests timeline = left_in(Place::kTimeline);
    CHECK(test::asked<ShowChampion>(timeline).generation == 3);
    CHECK_FALSE(test::was_asked<ShowIndividual>(timeline));
    const Requests population = left_in(Place::kPopulation);
    CHECK(test::was_asked<ShowIndividual>(population));
    CHECK_FALSE(test::was_asked<ShowChampion>(population));
}

TEST_CASE("the transport's controls do not overlap in a small window", "[studio][main_window]") {
    WindowRun run;
    run.draw();
    const Rect& fastest = run.gui.place("16×");
    CHECK(fastest.x + fastest.width < run.gui.place("Newest").x);
}

TEST_CASE("a notice lies over the viewport and can be dismissed", "[studio][main_window]") {
    WindowRun run;
    const Notice notice{NoticeKind::kProblem, "The disk is full; free some room and save again."};
    FrameContext frame = run.studio.frame();
    frame.window.notice = &notice;
    run.draw(frame);
    run.click("Dismiss", frame);
    CHECK(test::was_asked<DismissNotice>(run.out));
}

TEST_CASE("files lie over the panels and can be cancelled", "[studio][main_window]") {
    WindowRun run;
    run.studio.files().open = true;
    run.studio.files().opened = 1;
    run.draw();
    run.click("Cancel", run.studio.frame());
    CHECK(test::was_asked<CloseFilePanel>(run.out));
}

TEST_CASE("in selection by hand the controls are inside a window of 1280 by 720",
          "[studio][main_window][picking]") {
    WindowRun run;
    run.studio.show_grid(25);
    run.draw();
    for (const char* name :
         {"Automatic", "Hand-pick",    "Breed",   "cell 1",
          "cell 25",   "Back",         "Forward", "View",
          "Keep",      "Save…",        "Scores",  "Hints",
          "25",        "Wild",         "dial",    "Random creatures for the rest",
          "Assist",    "Inject picks", "New run", "Grid from the creature on display",
          "grid 1",    "shelf"}) {
        INFO(name);
        CHECK(test::inside(run.gui.place(name), 1280, 720));
    }
    CHECK(run.out.all().empty());
}

TEST_CASE("a creature of the grid dragged to the shelf is kept", "[studio][main_window][picking]") {
    WindowRun run;
    run.studio.show_grid(9);
    run.draw();
    run.gui.move_to(run.gui.place("cell 6").center());
    run.draw();
    run.gui.press();
    run.draw();
    run.gui.move_to(run.gui.place("shelf").center());
    run.draw();
    run.draw();
    run.gui.release();
    run.draw();
    CHECK(test::asked_picking<PinCreature>(run.out).cell == 5);
}

TEST_CASE("one creature of the grid can be shown alone, with a way back to the grid",
          "[studio][main_window][picking]") {
    WindowRun run;
    run.studio.show_grid(9);
    run.studio.show_single();
    run.draw();
    CHECK(run.gui.has("viewport"));
    CHECK_FALSE(run.gui.has("cell 1"));
    run.click("Back to the grid", run.studio.frame());
    CHECK(test::was_asked<ShowGrid>(run.out));
}

// A panel that the program does not have.
class MadeUpPanel final : public Panel {
public:
    void draw(const FrameContext&, Requests& out) override {
        ImGui::TextUnformatted("made up");
        note_place("made up");
        out.ask(FitView{});
    }
};

TEST_CASE("a panel is drawn in the area and under the condition of its registration",
          "[studio][main_window]") {
    const std::array kinds = {
        PanelKind{
            "left",
            {PanelArea::kLeft},
            [](const FrameContext& frame) { return frame.picking == nullptr; },
            [](Renderer*) -> std::unique_ptr<Panel> { return std::make_unique<MadeUpPanel>(); }},
    };
    NullImGui gui(1280, 720);
    MainWindow window{kinds, nullptr};
    test::StudioFixture studio;
    Requests out;
    gui.bare_frame([&] { window.draw(studio.frame(), out); });
    CHECK(test::was_asked<FitView>(out));
    const Layout layout = divide_window(1280, 720, studio.view(), 1.0F);
    CHECK(layout.experiment.contains(gui.place("made up").center()));
    studio.show_grid(4);
    Requests later;
    gui.bare_frame([&] { window.draw(studio.frame(), later); });
    CHECK_FALSE(test::was_asked<FitView>(later));
}

}  // namespace
}  // namespace cambrian
