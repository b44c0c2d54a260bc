// The paper on which a creature is drawn, and the line below it, with a mouse.

#include "panel_press.h"
#include "studio/actions/action.h"
#include "studio/panels/viewport/drawing_strip.h"
#include "studio/panels/viewport/viewport_panel.h"
#include "support/null_imgui.h"

#include <GLFW/glfw3.h>

namespace cambrian {
namespace {

// The paper with a crawler on it: a body of 0.8 m with a leg below each end.
struct Paper {
    NullImGui gui{1280.0F, 800.0F};
    ViewportPanel panel{nullptr};
    test::StudioFixture studio;
    DrawingView drawing{.on = true};
    Requests out;

    Paper() {
        studio.show_crawler();
        frame();
    }
    FrameContext context() const {
        FrameContext frame = studio.frame();
        frame.viewer.drawing = drawing;
        return frame;
    }
    void frame() {
        gui.frame([&] { panel.draw(context(), out); });
    }
    void move_to(const Vec2& place) {
        const Rect& area = gui.place("viewport");
        const Vec2 at = panel.camera().to_screen(
            place, {static_cast<double>(area.width), static_cast<double>(area.height)});
        gui.move_to({area.x + static_cast<float>(at.x()), area.y + static_cast<float>(at.y())});
        frame();
    }
    // Returns the requests of a drag.
    Requests drag(const Vec2& from, const Vec2& to) {
        move_to(from);
        out = {};
        gui.press();
        frame();
        move_to(0.5 * (from + to));
        move_to(to);
        gui.release();
        frame();
        return std::exchange(out, {});
    }
    Genome drawn(const Vec2& from, const Vec2& to) {
        const Requests requests = drag(from, to);
        CHECK(test::was_asked<FinishGeneEdit>(requests));
        return *test::asked<EditGenes>(requests).genome;
    }
    const Genome& shown() { return *studio.playback().exhibit().genome(); }
};

TEST_CASE("a drag from an edge of a part draws one more", "[studio][drawing]") {
    Paper paper;
    const Genome genome = paper.drawn({0.1, 0.1}, {0.1, 0.5});
    REQUIRE(genome.nodes.size() == paper.shown().nodes.size() + 1);
    CHECK(validate(genome, test::kind_catalog()).empty());
    CHECK(genome.nodes.back().length == Approx(0.4).margin(0.02));
    CHECK(genome.nodes[0].edges.back().angle == Approx(0.0).margin(0.05));
}

TEST_CASE("the new part is chosen, and a stroke is one edit", "[studio][drawing]") {
    Paper paper;
    const Requests out = paper.drag({0.1, 0.1}, {0.1, 0.5});
    std::size_t edits = 0;
    for (const StudioRequest& request : out.all())
        edits += test::request_if<EditGenes>(request) != nullptr ? 1U : 0U;
    CHECK(edits == 1);
    const auto& edit = test::asked<EditGenes>(out);
    CHECK(test::asked<ChoosePart>(out).part->uid == edit.genome->nodes.back().uid);
    CHECK(edit.change.to.ends_with("drawn"));
}

TEST_CASE("Ctrl puts the end of a stroke on the grid, and mirrored parts come in pairs",
          "[studio][drawing]") {
    Paper paper;
    paper.drawing.mirror = MirrorSides::kSideways;
    paper.gui.hold_control(true);
    const Genome genome = paper.drawn({0.2, 0.1}, {0.213, 0.487});
    CHECK(genome.nodes[0].edges.size() == 4);
    CHECK(genome.nodes.back().symmetric);
    const double reach = genome.nodes.back().length;
    CHECK(reach == Approx(0.4).margin(0.004));
}

TEST_CASE("the end of the body makes it longer without turning it", "[studio][drawing]") {
    Paper paper;
    paper.move_to({0.0, 0.0});
    const Genome genome = paper.drawn({0.4, 0.0}, {0.6, 0.03});
    CHECK(genome.nodes[0].length == Approx(1.2).margin(0.02));
    CHECK(genome.root_angle == 0.0);
    CHECK(genome.nodes.size() == paper.shown().nodes.size());
}

TEST_CASE("a click chooses a part and changes nothing", "[studio][drawing]") {
    Paper paper;
    const Requests out = paper.drag({0.0, 0.0}, {0.0, 0.0});
    CHECK(test::asked<ChoosePart>(out).part.has_value());
    CHECK_FALSE(test::was_asked<EditGenes>(out));
    const Requests beside = paper.drag({-0.7, 0.4}, {-0.7, 0.4});
    CHECK_FALSE(test::asked<ChoosePart>(beside).part.has_value());
}

TEST_CASE("dragging the paper moves the view and not the creature", "[studio][drawing]") {
    Paper paper;
    const Vec2 before = paper.panel.camera().center;
    const Requests out = paper.drag({-0.7, 0.4}, {-0.5, 0.4});
    CHECK_FALSE(test::was_asked<EditGenes>(out));
    CHECK(paper.panel.camera().center.x() < before.x() - 0.05);
}

TEST_CASE("the paper's buttons play, evolve and begin anew", "[studio][drawing]") {
    Paper paper;
    const auto press = [&](const char* name) {
        paper.out = {};
        paper.gui.click(name, [&] { paper.panel.draw(paper.context(), paper.out); });
        return std::exchange(paper.out, {});
    };
    CHECK(test::was_asked<ToggleDrawing>(press("Play it")));
    CHECK(test::was_asked<EvolveShown>(press("Evolve from it")));
    CHECK(test::was_asked<DrawNewCreature>(press("New creature")));
    CHECK(test::was_asked<ToggleDrawing>(press("Draw creature")));
}

TEST_CASE("the line below the paper acts on the chosen part", "[studio][drawing]") {
    NullImGui gui;
    DrawingStrip strip;
    test::StudioFixture studio;
    studio.show_crawler();
    const Genome& genome = *studio.playback().exhibit().genome();
    DrawingView drawing{.on = true};
    const auto press = [&](const char* name) {
        Requests out;
        gui.click(name, [&] {
            FrameContext frame = studio.frame();
            frame.viewer.drawing = drawing;
            strip.draw(frame, out);
        });
        return out;
    };
    CHECK(press("Remove").all().empty());
    drawing.chosen = PartName{genome.nodes[1].uid, 0, 1};
    CHECK(test::asked<RepeatPart>(press("repeat more")).times == 2);
    CHECK(press("repeat less").all().empty());
    CHECK(test::was_asked<RemovePart>(press("Remove")));
    CHECK(test::was_asked<SwitchPair>(press("Both sides")));
    drawing.chosen = PartName{genome.nodes[0].uid, 0, 0};
    CHECK(press("Remove").all().empty());  // the first part stays
}

TEST_CASE("the line below the paper gives a rhythm and has sliders for it", "[studio][drawing]") {
    NullImGui gui;
    DrawingStrip strip;
    test::StudioFixture studio;
    // Its hind leg is a quarter of a swing ahead, so that no wave runs from it to the other one.
    studio.show_crawler();
    Requests out;
    gui.click("Give it a rhythm", [&] { strip.draw(studio.frame(), out); });
    const Rhythm given = test::asked<GiveRhythm>(out).rhythm;
    const ExpressionSettings expression;
    const SceneSettings scene;
    const SketchRules rules{test::creature_kinds(), expression, scene};
    auto moving =
        with_rhythm(sketch_of(*studio.playback().exhibit().genome(), rules), given, rules);
    REQUIRE(moving);
    REQUIRE(studio.playback().show(
        test::walking_exhibit(std::make_shared<const Genome>(*std::move(moving)))));
    out = {};
    gui.click("Beat", [&] { strip.draw(studio.frame(), out); });
    CHECK(test::asked<GiveRhythm>(out).rhythm.frequency > given.frequency);
    CHECK(test::was_asked<FinishGeneEdit>(out));
}

TEST_CASE("keys of the paper hide those that mean something else", "[studio][drawing]") {
    test::StudioFixture studio;
    studio.show_crawler();
    FrameContext frame = studio.frame();
    const auto press = [&](int key, bool shift = false) {
        Requests out;
        press_shortcut({key, false, shift}, false, frame, out);
        return out;
    };
    CHECK(test::was_asked<ToggleDrawing>(press(GLFW_KEY_D, true)));
    CHECK(test::was_asked<TogglePlayback>(press(GLFW_KEY_P)));
    frame.viewer.drawing.on = true;
    CHECK(test::was_asked<ToggleDrawing>(press(GLFW_KEY_P)));
    CHECK(test::was_asked<ToggleDrawing>(press(GLFW_KEY_ESCAPE)));
    CHECK(test::was_asked<RemovePart>(press(GLFW_KEY_DELETE)));
    CHECK(test::asked<MirrorNewParts>(press(GLFW_KEY_M)).sides == MirrorSides::kSideways);
    CHECK(test::was_asked<SwitchPair>(press(GLFW_KEY_M, true)));
    frame.window.presenting = true;
    CHECK_FALSE(frame.drawing());
}

}  // namespace
}  // namespace cambrian
