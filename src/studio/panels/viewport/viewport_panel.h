#pragma once

#include "pictures/scene_builder.h"
#include "studio/frame/panel.h"
#include "studio/host/scene_canvas.h"

#include <memory>
#include <string>

namespace cambrian {

// The creature on show in its world, with camera and mouse.
class ViewportPanel final : public Panel {
public:
    // Without a renderer (tests) everything but the picture works.
    explicit ViewportPanel(Renderer* renderer) { canvas_.renderer = renderer; }

    void draw(const FrameContext& frame, Requests& out) override;
    const Camera& camera() const { return canvas_.camera; }
    const SceneFrame& scene() const { return canvas_.frame; }

private:
    void place_camera(const FrameContext& frame);
    void fit_now(const FrameContext& frame);
    Vec2 follow_target(const FrameContext& frame) const;
    void handle_mouse(const FrameContext& frame, Requests& out);
    void handle_poke(const FrameContext& frame, Requests& out);
    void build_scene(const FrameContext& frame);
    void draw_words(const FrameContext& frame);
    void draw_marks(const FrameContext& frame);
    void add_overlays(const FrameContext& frame, const CreatureLook& look);
    void draw_plate(const Vec2& at, const std::string& name) const;
    void draw_part_names(const FrameContext& frame) const;
    void draw_ghost_labels(const FrameContext& frame) const;
    Vec2 mouse_in_world() const;

    SceneCanvas canvas_;
    Viewport size_;
    bool fit_wanted_ = true;
    unsigned fits_seen_ = 0;           // requests to fit the creature into view, so far
    const Phenotype* seen_ = nullptr;  // on show at the last draw; compared only
    bool panning_ = false;
};

}  // namespace cambrian
