#pragma once

// Presses of a person in a single panel, and the requests of the panel.

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

// A key held for one frame, with the keyboard in the panel.
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

// A panel alone in a window of its own; `out` gathers all that it asked for.
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
    // What this click asked for; gathered too.
    Requests click(const std::string& name, int button = 0) {
        Requests asked = test::click(gui, panel, studio, name, button);
        for (const StudioRequest& request : asked.all())
            std::visit([this](const auto& each) { out.ask(each); }, request);
        return asked;
    }
    Requests press_key(ImGuiKey key) { return test::press_key(gui, panel, studio, key); }
};

}  // namespace cambrian::test
