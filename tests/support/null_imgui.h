#pragma once

// Dear ImGui without a window or graphics card, with a synthetic mouse. Tests draw something, click
// a control by the name it recorded, and check the result.

#include "studio/look/ui_context.h"
#include "support/catch.h"

#include <imgui.h>

#include <string>
#include <utility>

namespace cambrian {

class NullImGui {
public:
    explicit NullImGui(float width = 1280.0F, float height = 800.0F) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.UserData = &context_;
        io.IniFilename = nullptr;
        io.DisplaySize = {width, height};
        io.DeltaTime = 1.0F / 60.0F;
        for (int key = 0; key < ImGuiKey_COUNT; ++key)
            io.KeyMap[key] = key;
        unsigned char* pixels = nullptr;
        int atlas_width = 0;
        int atlas_height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &atlas_width, &atlas_height);
        ImFont* font = io.Fonts->Fonts[0];
        context_.fonts = {font, font, font, font, font};
        apply_style(context_.palette, 1.0F);
    }
    ~NullImGui() { ImGui::DestroyContext(); }
    NullImGui(const NullImGui&) = delete;
    NullImGui& operator=(const NullImGui&) = delete;

    // Runs one frame of `draw` inside a window that fills the display.
    template <class Draw>
    void frame(Draw draw) {
        bare_frame([&draw] {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
            ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
            draw();
            ImGui::End();
        });
    }
    // Runs one frame of `draw`, which opens its own windows.
    template <class Draw>
    void bare_frame(Draw draw) {
        ImGui::NewFrame();
        draw();
        ImGui::Render();
    }

    // Runs the frames of a click on a named control; `draw` sees the click in the last one.
    template <class Draw>
    void click(const std::string& name, Draw draw, int button = 0) {
        frame(draw);
        move_to(place(name).center());
        frame(draw);
        press(button);
        frame(draw);
        release(button);
        frame(draw);
    }

    const Rect& place(const std::string& name) const {
        INFO("no control noted its place as '" << name << "'");
        REQUIRE(context_.places.count(name) == 1);
        return context_.places.at(name).rect;
    }
    bool has(const std::string& name) const { return context_.places.count(name) == 1; }
    void move_to(const ImVec2& point) { ImGui::GetIO().MousePos = point; }
    void press(int button = 0) { ImGui::GetIO().MouseDown[button] = true; }
    void release(int button = 0) { ImGui::GetIO().MouseDown[button] = false; }
    void hold_control(bool held) { ImGui::GetIO().KeyCtrl = held; }
    void hold_key(ImGuiKey key, bool held) { ImGui::GetIO().KeysDown[key] = held; }
    void forget_places() { context_.places.clear(); }

private:
    UiContext context_;
};

}  // namespace cambrian
