#pragma once

// Draws all panels in their places.

#include "studio/frame/panel.h"
#include "studio/layout.h"

#include <memory>
#include <span>
#include <vector>

namespace cambrian {

class MainWindow {
public:
    // `kinds` must outlive the object.
    MainWindow(std::span<const PanelKind> kinds, Renderer* renderer);

    // May be called only between the host's begin_frame() and end_frame().
    void draw(const FrameContext& frame, Requests& out);
    // Returns the place of the viewport, the grid or the world in the frame drawn last, in pixels.
    const Rect& center() const { return center_; }

private:
    void draw_areas(const FrameContext& frame, const Layout& layout, Requests& out);
    void draw_cards(const FrameContext& frame, const Layout& layout, Requests& out);

    std::span<const PanelKind> kinds_;
    std::vector<std::unique_ptr<Panel>> panels_;  // one panel per kind
    Rect center_;
};

}  // namespace cambrian
