#pragma once

#include "core/result.h"
#include "studio/frame/frame_context.h"
#include "studio/host/scene_canvas.h"
#include "studio/panels/viewport/pen_handles.h"

#include <optional>
#include <string>

namespace cambrian {

// Draws the displayed creature's body with the mouse. While the button is held, the body that the
// stroke would make is shown; when it is released, the stroke becomes one edit of the genes.
class DrawingPen {
public:
    // Must be called first in each frame, with a creature on display.
    void follow(const FrameContext& frame);
    // Returns whether the mouse moves the view.
    bool handle_mouse(const FrameContext& frame, const SceneCanvas& canvas, Requests& out);

    // The body as it would be if the button were released now.
    const BodySketch& body() const { return preview_ ? preview_->sketch : sketch_; }
    // The part whose handles are shown, and what a press would take hold of.
    std::optional<std::size_t> lit() const { return lit_; }
    const PenAim& aim() const { return aim_; }
    bool is_drawing() const { return held_ && moved_; }
    // The part that the stroke makes or changes.
    std::optional<std::size_t> drawn() const {
        return preview_ ? std::optional(preview_->part) : std::nullopt;
    }
    // What is drawn, or why nothing can be; empty between strokes.
    const std::string& words() const { return words_; }
    Vec2 tip() const { return tip_; }  // of the pen, on the grid if that is asked for
    bool refused() const { return is_drawing() && !preview_; }

private:
    struct Stroke {
        BodySketch sketch;
        GeneChange change;
        std::size_t part = 0;  // of that body, at which the pen is
    };
    void look_around(const DrawingView& drawing);
    void press(Requests& out);
    void draw_on(const FrameContext& frame);
    void finish(Requests& out);
    Result<Stroke> stroke(const FrameContext& frame) const;
    Result<Stroke> growth(const FrameContext& frame) const;
    Genome reshaped() const;
    Vec2 steadied(const Vec2& end) const;

    GenomePtr genome_;  // that was sketched
    BodySketch sketch_;
    std::optional<std::size_t> lit_;
    PenAim aim_;
    double unit_ = 0.01;  // m; length of 1/96 inch
    Vec2 tip_ = Vec2::Zero();
    // Of the stroke.
    bool held_ = false;
    bool moved_ = false;
    Vec2 pressed_ = Vec2::Zero();
    std::optional<Stroke> preview_;
    std::string words_;
};

}  // namespace cambrian
