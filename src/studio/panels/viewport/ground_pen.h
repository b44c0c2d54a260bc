#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"
#include "studio/host/scene_canvas.h"
#include "world/terrain.h"

#include <vector>

namespace cambrian {

// Draws ground in the viewport: a stroke with the left button replaces the profile between its
// ends. Each is one edit of the settings.
class GroundPen {
public:
    // Returns whether the pen has the left button.
    bool handle_mouse(const FrameContext& frame, const SceneCanvas& canvas, Requests& out);
    // Shows the stroke as it would become ground.
    void add_stroke(SceneCanvas& canvas) const;
    // Says how it is used, along the bottom of the canvas.
    static void draw_hint(const SceneCanvas& canvas);

private:
    std::vector<GroundPoint> stroke_;  // empty unless the button is held
};

}  // namespace cambrian
