#pragma once

// Draws a scene with our renderer inside an ImGui window, directly into the window's framebuffer.
// No texture is copied.

#include "render/renderer.h"
#include "studio/look/ui_context.h"

namespace cambrian {

constexpr double kNotchFactor = 1.15;  // zoom factor of a notch of the wheel

struct SceneCanvas {
    Renderer* renderer = nullptr;  // null in tests, which draw no scene
    int framebuffer_height = 1;    // height of the window's framebuffer, in pixels
    SceneFrame frame;
    Camera camera;
    Rect area;  // of the window, in pixels

    Viewport size() const;        // of the area; at least 1 pixel each way
    Vec2 mouse_in_world() const;  // m
    // Zooms by the notches that the wheel was turned in this frame, about the mouse or the middle.
    void zoom_by_wheel(bool about_middle);

    // Adds the scene to a draw list. It is drawn with that list, below what is added later. The
    // canvas must not move or be destroyed before that.
    void add_to(ImDrawList& list);
};

}  // namespace cambrian
