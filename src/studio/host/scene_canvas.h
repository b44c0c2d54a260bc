#pragma once

// Lets our renderer draw inside an ImGui window, straight into the window's framebuffer: one pass
// over the pixels, no picture to copy.

#include "render/renderer.h"
#include "studio/look/ui_context.h"

namespace cambrian {

struct SceneCanvas {
    Renderer* renderer = nullptr;  // none in tests: nothing is drawn
    int framebuffer_height = 1;    // pixels
    SceneFrame frame;
    Camera camera;
    Rect area;

    // Draws when the present window's draw list is, under whatever is added to it later. This
    // must stay where it is until then.
    void add_to(ImDrawList& list);
};

}  // namespace cambrian
