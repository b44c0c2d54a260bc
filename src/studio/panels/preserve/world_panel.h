#pragma once

#include "studio/frame/panel.h"
#include "studio/host/scene_canvas.h"
#include "studio/preserve/preserve_view.h"

#include <cstdint>

namespace cambrian {

// Shows a preserve; the mouse picks, moves and feeds creatures and moves the camera.
class WorldPanel final : public Panel {
public:
    // Without a renderer, as in tests, the panel works but draws no scene.
    explicit WorldPanel(Renderer* renderer) { canvas_.renderer = renderer; }

    void draw(const FrameContext& frame, Requests& out) override;
    const Camera& camera() const { return canvas_.camera; }

private:
    void place_camera(const FrameContext& frame);
    void handle_mouse(const FrameContext& frame, Requests& out);
    void handle_left_button(const FrameContext& frame, Requests& out);
    void handle_wall(const WallTool& wall, Requests& out);
    void draw_wall(const WallTool& wall);
    void handle_keys(const FrameContext& frame, Requests& out);
    void pan(const ImVec2& pixels, const FrameContext& frame, Requests& out);
    void aim(Requests& out);
    void draw_labels(const FrameContext& frame);
    void draw_words(const FrameContext& frame) const;
    ImVec2 on_screen(const Vec2& point) const;

    SceneCanvas canvas_;
    unsigned fits_seen_ = 0;  // number of FitWorld requests handled so far
    std::uint64_t held_ = 0;  // creature under the left button when it was pressed
    bool pressed_ = false;    // the left button was pressed in the world
    bool hovered_ = false;
    bool walling_ = false;     // the button was pressed for an end of a wall
    Vec2 aim_ = Vec2::Zero();  // m; as asked last
};

}  // namespace cambrian
