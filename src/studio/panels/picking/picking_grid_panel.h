#pragma once

#include "picking/grid_hints.h"
#include "picking/grid_settings.h"
#include "studio/frame/panel.h"
#include "studio/host/scene_canvas.h"

#include <array>

namespace cambrian {

// The grid of selection by hand: every creature in its cell, all moving by one clock and drawn to
// one scale. A click picks, a double click shows the creature alone.
class PickingGridPanel final : public Panel {
public:
    // Without a renderer (tests) everything but the picture works.
    explicit PickingGridPanel(Renderer* renderer);

    void draw(const FrameContext& frame, Requests& out) override;

private:
    void place_cells(std::size_t count, const Rect& area);
    void choose_scale(const GridMotion& motion);
    void look_for_hints(const FrameContext& frame);
    void build_scene(std::size_t cell, const FrameContext& frame);
    void draw_cell(std::size_t cell, const FrameContext& frame, Requests& out);
    void draw_words(std::size_t cell, const FrameContext& frame);
    const char* hint(std::size_t cell) const;

    std::array<SceneCanvas, kGridSizes.back()> canvases_;  // one a cell
    Viewport size_;                                        // of each
    double scale_ = 0.0;                                   // pixels a metre, of all
    GridHints hints_;
    const Individual* hinted_ = nullptr;  // first creature they are of; compared only
    std::uint32_t hinted_grid_ = 0;
};

}  // namespace cambrian
