#pragma once

#include "studio/panels/viewport/drawing_pen.h"

namespace cambrian {

// The viewport while the displayed creature is drawn: its body at rest on paper, with handles.
class DrawingPaper {
public:
    void handle_mouse(const FrameContext& frame, SceneCanvas& canvas, Requests& out);
    void place_camera(SceneCanvas& canvas, bool fits);
    void build_scene(const FrameContext& frame, SceneCanvas& canvas) const;
    // Writes over the scene; the buttons beside the title make requests.
    void draw_words(const SceneCanvas& canvas, Requests& out) const;

private:
    void add_ground(const FrameContext& frame, SceneCanvas& canvas) const;
    void add_body(const FrameContext& frame, SceneCanvas& canvas) const;
    void add_frame_of(SceneCanvas& canvas, std::size_t part, const Color& color) const;
    void add_mirror(SceneCanvas& canvas, MirrorSides sides) const;
    void add_handles(SceneCanvas& canvas) const;

    DrawingPen pen_;
};

}  // namespace cambrian
