#pragma once

#include "picking/grid/grid_hints.h"
#include "picking/grid/grid_settings.h"
#include "studio/frame/panel.h"
#include "studio/host/scene_canvas.h"

#include <array>

namespace cambrian {

// Shows the grid of selection by hand. All creatures move by one clock and are drawn to one scale.
// A click picks a creature, a double click displays it alone.
class PickingGridPanel final : public Panel {
public:
    // Without a renderer, as in tests, the panel works but draws no scene.
    explicit PickingGridPanel(Renderer* renderer);

    void draw(const FrameContext& frame, Requests& out) override;

private:
    void place_cells(std::size_t count, const Rect& area);
    void choose_scale(const GridMotion& motion);
    void look_for_hints(const FrameContext& frame);
    void build_space(std::size_t cell, const MotionFrame& shown, const FrameContext& frame);
    void build_scene(std::size_t cell, const FrameContext& frame);
    void draw_cell(std::size_t cell, const FrameContext& frame, Requests& out);
    void draw_words(std::size_t cell, const FrameContext& frame);
    const char* hint(std::size_t cell) const;

    std::array<SceneCanvas, kGridSizes.back()> canvases_;  // one per cell
    Viewport size_;                                        // size of each canvas
    double scale_ = 0.0;  // pixels per metre, the same in all cells
    GridHints hints_;
    // The grid that the hints belong to, named by its first creature. The pointer is only compared.
    const Individual* hinted_ = nullptr;
    std::uint32_t hinted_grid_ = 0;
};

}  // namespace cambrian
