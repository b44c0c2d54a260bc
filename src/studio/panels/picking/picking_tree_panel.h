#pragma once

#include "studio/frame/panel.h"
#include "studio/hand_picking/picking_map.h"
#include "studio/look/ui_context.h"
#include "studio/widgets/phenotype_cache.h"

#include <optional>

namespace cambrian {

// Shows all grids as a map: later ones at the right, branches below. A click displays a grid.
class PickingTreePanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void draw_map(const FrameContext& frame, Requests& out);
    void draw_grid(std::uint32_t number, const Rect& tile, const FrameContext& frame,
                   Requests& out);
    void keep_in_sight(std::uint32_t current, const Rect& tile);

    PhenotypeCache bodies_;
    std::optional<std::uint32_t> seen_;  // number of the grid that was scrolled to last
};

}  // namespace cambrian
