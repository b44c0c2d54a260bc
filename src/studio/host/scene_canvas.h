#pragma once

// Draws a scene with our renderer inside an ImGui window, directly into the window's framebuffer.
// No texture is copied.

#include "render/renderer.h"
#include "studio/look/ui_context.h"

namespace cambrian {

struct SceneCanvas {
    Renderer* renderer = nullptr;  // null in tests, which draw no scene
    int framebuffer_height = 1;    // height of the window's framebuffer, in pixels
    SceneFrame frame;
    Camera camera;
    Rect area;

    // Adds the scene to a draw list. It is drawn with that list, below what is added later. The
    // canvas must not move or be destroyed before that.
    void add_to(ImDrawList& list);
};

}  // namespace cambrian
