#pragma once

// Dear ImGui's context, its back-ends, fonts and style.

#include "core/result.h"
#include "render/opengl/pixels.h"
#include "render/picture_stamp.h"
#include "studio/host/changed_areas.h"
#include "studio/look/ui_context.h"

#include <functional>
#include <vector>

namespace cambrian {

class Window;
struct KeyPress;

class ImGuiHost {
public:
    // The window's OpenGL context must be current and stay so.
    ImGuiHost(Window& window, float scale, ThemeKind theme);
    ~ImGuiHost();
    ImGuiHost(const ImGuiHost&) = delete;
    ImGuiHost& operator=(const ImGuiHost&) = delete;

    // Keys pressed since the last frame count even if they were released at once.
    void begin_frame(const std::vector<KeyPress>& pressed);
    // Has everything in the window's framebuffer; paints only what changed.
    void end_frame();
    // Something drawn by itself, on the panels' colour; between begin_frame and end_frame.
    Result<Image> picture(int width, int height, const std::function<void(ImDrawList&)>& draw);
    void set_theme(ThemeKind theme);
    const UiContext& context() const { return context_; }

private:
    Window& window_;
    UiContext context_;
    PictureStamp stamp_;
    ChangedAreas changed_;
};

}  // namespace cambrian
