#pragma once

#include "pictures/scene/scene_builder.h"
#include "studio/frame/panel.h"
#include "studio/host/scene_canvas.h"
#include "studio/panels/viewport/drawing_paper.h"
#include "studio/panels/viewport/ground_pen.h"
#include "studio/panels/viewport/space_view.h"

#include <memory>
#include <string>

namespace cambrian {

// Shows the displayed creature in its world; the mouse moves the camera and pulls parts.
class ViewportPanel final : public Panel {
public:
    // Without a renderer, as in tests, the panel works but draws no scene.
    explicit ViewportPanel(Renderer* renderer) { canvas_.renderer = renderer; }

    void draw(const FrameContext& frame, Requests& out) override;
    const Camera& camera() const { return canvas_.camera; }
    const SceneFrame& scene() const { return canvas_.frame; }

private:
    void place_camera(const FrameContext& frame);
    void fit_now(const FrameContext& frame);
    Vec2 follow_target(const FrameContext& frame) const;
    void handle_mouse(const FrameContext& frame, Requests& out);
    bool handle_light(const FrameContext& frame, Requests& out);
    void handle_poke(const FrameContext& frame, Requests& out);
    void build_scene(const FrameContext& frame);
    void add_shown_light(const FrameContext& frame, const Vec2& place);
    void add_company(const FrameContext& frame, const CreatureLook& look);
    void add_overlays(const FrameContext& frame, const CreatureLook& look);

    void draw_space(const FrameContext& frame, Requests& out);
    void draw_paper(const FrameContext& frame, Requests& out);

    SceneCanvas canvas_;
    SpaceView space_;
    GroundPen pen_;
    DrawingPaper paper_;
    bool fit_wanted_ = true;
    unsigned fits_seen_ = 0;           // number of FitView requests handled so far
    const Phenotype* seen_ = nullptr;  // creature of the last frame; compared only
    bool panning_ = false;
    bool light_held_ = false;
};

}  // namespace cambrian
