#pragma once

// Owns Dear ImGui's context with its back-ends, fonts and style.

#include "core/result.h"
#include "render/opengl/pixels.h"
#include "render/picture_stamp.h"
#include "studio/host/changed_areas.h"
#include "studio/host/clipboard.h"
#include "studio/host/textures.h"
#include "studio/host/tile_pictures.h"
#include "studio/look/ui_context.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace cambrian {

class Window;
struct KeyPress;

class ImGuiHost {
public:
    // The window's OpenGL context must be current and stay current.
    // The renderer draws the pictures of tiles and must outlive the object.
    ImGuiHost(Window& window, Renderer& renderer, float scale, ThemeKind theme);
    ~ImGuiHost();
    ImGuiHost(const ImGuiHost&) = delete;
    ImGuiHost& operator=(const ImGuiHost&) = delete;

    // Keys pressed since the last frame count even if they were released again. Tab goes from
    // control to control unless something else is done with it.
    // Returns whether a text field gets the keys of this frame.
    bool begin_frame(const std::vector<KeyPress>& pressed, bool tab_moves);
    // Closes the menu or pop-up that was opened last; returns false if there is none.
    static bool close_popup();
    // Draws the frame into the window's framebuffer and waits until that is done. Only changed
    // areas are painted.
    void end_frame();
    // Draws a picture of its own on the panels' background colour. May be called only between
    // begin_frame() and end_frame().
    Result<Image> picture(int width, int height, const std::function<void(ImDrawList&)>& draw);
    // Returns why a control refused what was typed, once; empty if none did.
    std::string take_complaint() { return std::exchange(context_.complaint, {}); }
    void set_theme(ThemeKind theme);
    // May be called only between frames. All typefaces are rasterised again.
    void set_scale(float scale);
    void set_look(LookMode look) { context_.look = look; }
    const UiContext& context() const { return context_; }

private:
    void use_clipboard();
    void make_letters();

    Window& window_;
    UiContext context_;
    Textures textures_;
    TilePictures tiles_;
    PictureStamp stamp_;
    ChangedAreas changed_;
    Clipboard clipboard_;
    std::string pasted_;  // the text that was asked of the clipboard last
};

}  // namespace cambrian
