#pragma once

#include "pictures/scene/scene_builder.h"
#include "studio/frame/panel.h"
#include "studio/host/scene_canvas.h"
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
    void draw_words(const FrameContext& frame);
    void draw_marks(const FrameContext& frame);
    void add_overlays(const FrameContext& frame, const CreatureLook& look);
    void draw_plate(const Vec2& at, const std::string& name) const;
    void draw_wall_sign(const FrameContext& frame) const;
    void draw_part_names(const FrameContext& frame) const;
    void draw_ghost_labels(const FrameContext& frame) const;
    std::string ghost_words(const Ghost& ghost, const WorldWindow& bounds, double here) const;

    // Returns where the canvas has a point of the world.
    Vec2 on_canvas(const FrameContext& frame, const Vec3& point) const;
    void draw_space(const FrameContext& frame, Requests& out);
    void draw_space_marks(const FrameContext& frame);
    void draw_space_ghost_labels(const FrameContext& frame) const;

    SceneCanvas canvas_;
    SpaceView space_;
    bool fit_wanted_ = true;
    unsigned fits_seen_ = 0;           // number of FitView requests handled so far
    const Phenotype* seen_ = nullptr;  // creature of the last frame; compared only
    bool panning_ = false;
    bool light_held_ = false;
};

}  // namespace cambrian
