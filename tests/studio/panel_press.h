#pragma once

// Mouse and keyboard input to a single panel, and the panel's requests.

#include "studio/frame/panel.h"
#include "studio_fixture.h"
#include "support/null_imgui.h"

#include <string>

namespace cambrian::test {

inline Requests click(NullImGui& gui, Panel& panel, const StudioFixture& studio,
                      const std::string& name, int button = 0) {
    Requests out;
    gui.click(
        name, [&] { panel.draw(studio.frame(), out); }, button);
    return out;
}

// Holds a key for one frame while the panel has the keyboard focus.
inline Requests press_key(NullImGui& gui, Panel& panel, const StudioFixture& studio, ImGuiKey key) {
    Requests out;
    const auto draw = [&] {
        ImGui::SetWindowFocus();
        panel.draw(studio.frame(), out);
    };
    gui.frame(draw);
    gui.hold_key(key, true);
    gui.frame(draw);
    gui.hold_key(key, false);
    gui.frame(draw);
    return out;
}

// A panel in a window of its own; `out` collects its requests.
template <class Kind>
struct PanelRun {
    NullImGui gui;
    StudioFixture studio;
    Kind panel;
    Requests out;

    PanelRun(float width, float height) : gui(width, height) {}

    void frame() {
        gui.frame([this] { panel.draw(studio.frame(), out); });
    }
    // Returns the requests of this click, which are also collected.
    Requests click(const std::string& name, int button = 0) {
        Requests asked = test::click(gui, panel, studio, name, button);
        ask_again(asked, out);
        return asked;
    }
    Requests press_key(ImGuiKey key) { return test::press_key(gui, panel, studio, key); }
};

}  // namespace cambrian::test
