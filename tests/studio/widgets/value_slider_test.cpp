#include "studio/widgets/value_slider.h"

#include "support/null_imgui.h"

#include <utility>

namespace cambrian {
namespace {

// Two sliders, one above the other.
class TwoSliders {
public:
    void frame() {
        gui.frame([this] {
            slider("first", first);
            slider("second", second);
        });
    }
    void press_at(const std::string& name, bool control) {
        gui.move_to(gui.place(name).center());
        frame();
        gui.hold_control(control);
        gui.press();
        frame();
        gui.release();
        gui.hold_control(false);
        frame();
    }
    void type(const char* text) {
        ImGui::GetIO().AddInputCharactersUTF8(text);
        frame();
        frame();
    }

    NullImGui gui;
    double first = 1.0;
    double second = 2.0;

private:
    static void slider(const char* name, double& value) {
        ImGui::PushID(name);
        value_slider(value,
                     {.range = {0.0, 10.0}, .width = 200.0F, .allowed = SliderRange{0.0, 100.0}});
        note_place(name);
        ImGui::PopID();
    }
};

TEST_CASE("a typed number is set when it is complete", "[studio][value_slider]") {
    TwoSliders sliders;
    sliders.frame();
    sliders.press_at("first", true);
    sliders.type("7");
    CHECK(sliders.first == 1.0);
    sliders.gui.hold_key(ImGuiKey_Enter, true);
    sliders.frame();
    sliders.gui.hold_key(ImGuiKey_Enter, false);
    sliders.frame();
    CHECK(sliders.first == 7.0);
    CHECK(sliders.second == 2.0);
}

TEST_CASE("a number typed into one slider never reaches another", "[studio][value_slider]") {
    TwoSliders sliders;
    sliders.frame();
    sliders.press_at("second", true);
    sliders.type("7");
    // The first one is drawn before the second one is left.
    sliders.press_at("first", true);
    CHECK(sliders.first == 1.0);
    CHECK(sliders.second == 7.0);
    sliders.type("3");
    sliders.press_at("second", true);
    CHECK(sliders.first == 3.0);
    CHECK(sliders.second == 7.0);
}

TEST_CASE("a typed number is understood completely or refused", "[studio][value_slider]") {
    TwoSliders sliders;
    sliders.frame();
    const auto type = [&](const char* text) {
        sliders.press_at("first", true);
        sliders.type(text);
        sliders.gui.hold_key(ImGuiKey_Enter, true);
        sliders.frame();
        sliders.gui.hold_key(ImGuiKey_Enter, false);
        sliders.frame();
        return std::exchange(ui().complaint, {});
    };
    CHECK(type("1,5").empty());
    CHECK(sliders.first == 1.5);
    CHECK(type("0x10") == "“0x10” is not a number. The value stays as it was.");
    CHECK(sliders.first == 1.5);
    CHECK(type("1,500") != "");
    CHECK(sliders.first == 1.5);
    CHECK(type("101") == "101 is not allowed here; 0 to 100 is. The value stays as it was.");
    CHECK(type("99").empty());
    CHECK(sliders.first == 99.0);
}

}  // namespace
}  // namespace cambrian
