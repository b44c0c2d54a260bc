#include "studio/widgets/keyboard_focus.h"

#include "studio/widgets/value_slider.h"
#include "studio/widgets/widgets.h"
#include "support/null_imgui.h"

namespace cambrian {
namespace {

// Two buttons with a slider between them, and a card that may lie over them.
struct Controls {
    NullImGui gui;
    int first = 0;
    int last = 0;
    int in_card = 0;
    bool card = false;
    double value = 1.0;

    void frame(int steps = 0) {
        ui().places.clear();
        gui.bare_frame([&] {
            begin_focus_frame(steps);
            ImGui::Begin("controls");
            first += push_button("first") ? 1 : 0;
            value_slider(value, {.range = {0.0, 10.0}, .width = 200.0F});
            note_place("slider");
            last += push_button("last") ? 1 : 0;
            ImGui::End();
            if (!card) return;
            ImGui::Begin("card");
            begin_focus_layer();
            in_card += push_button("in card") ? 1 : 0;
            ImGui::End();
        });
    }
    void press_enter() {
        gui.hold_key(ImGuiKey_Enter, true);
        frame();
        gui.hold_key(ImGuiKey_Enter, false);
        frame();
    }
    // Whether the ring is around a control that the last frame drew.
    bool ring_at(const char* name) const {
        return gui.has("## keyboard focus") &&
               gui.place("## keyboard focus").contains(gui.place(name).center());
    }
};

TEST_CASE("Tab shows which control it reached, and Enter presses it", "[studio][keyboard_focus]") {
    Controls controls;
    controls.frame();
    controls.frame();
    CHECK_FALSE(controls.gui.has("## keyboard focus"));
    controls.frame(1);
    CHECK(controls.ring_at("first"));
    CHECK(control_focused());
    controls.press_enter();
    CHECK(controls.first == 1);
    controls.frame(-1);
    CHECK(controls.ring_at("last"));
    controls.press_enter();
    CHECK(controls.last == 1);
    CHECK(controls.first == 1);
}

TEST_CASE("arrows go through an open list of choices from the chosen one, and Enter takes a line",
          "[studio][keyboard_focus]") {
    NullImGui gui;
    int chosen = 1;
    const auto frame = [&](int steps = 0) {
        ui().places.clear();
        gui.bare_frame([&] {
            begin_focus_frame(steps);
            ImGui::Begin("controls");
            if (begin_choice("##list", "list", 200.0F)) {
                for (int i = 0; i < 4; ++i) {
                    if (choice_line("line " + std::to_string(i), i == chosen)) chosen = i;
                    note_place("line " + std::to_string(i));
                }
                ImGui::EndCombo();
            }
            ImGui::End();
        });
    };
    const auto press = [&](ImGuiKey key) {
        gui.hold_key(key, true);
        frame();
        gui.hold_key(key, false);
        frame();
        frame();
    };
    frame();
    frame(1);
    press(ImGuiKey_Enter);
    REQUIRE(popup_open());
    press(ImGuiKey_DownArrow);
    CHECK(gui.place("## keyboard focus").contains(gui.place("line 2").center()));
    press(ImGuiKey_DownArrow);
    press(ImGuiKey_UpArrow);
    press(ImGuiKey_Enter);
    CHECK(chosen == 2);
    CHECK_FALSE(popup_open());
}

TEST_CASE("Tab goes through a number that is typed and takes it", "[studio][keyboard_focus]") {
    Controls controls;
    controls.frame();
    controls.frame(1);
    controls.frame(1);
    controls.frame();
    controls.frame();
    CHECK(controls.ring_at("slider"));
    CHECK_FALSE(control_focused());
    ImGui::GetIO().AddInputCharactersUTF8("7");
    controls.frame();
    controls.frame();
    controls.frame(1);
    controls.frame();
    CHECK(controls.value == 7.0);
    CHECK(controls.ring_at("last"));
}

TEST_CASE("Tab stays within what lies on top, and a click takes the ring away",
          "[studio][keyboard_focus]") {
    Controls controls;
    controls.card = true;
    controls.frame();
    for (int i = 0; i < 3; ++i) {
        controls.frame(1);
        CHECK(controls.ring_at("in card"));
    }
    controls.press_enter();
    CHECK(controls.in_card == 1);
    controls.gui.press();
    controls.frame();
    CHECK_FALSE(controls.gui.has("## keyboard focus"));
}

}  // namespace
}  // namespace cambrian
