#pragma once

#include "studio/frame/panel.h"
#include "studio/look/ui_context.h"
#include "studio/panels/generations/tile_list.h"
#include "studio/widgets/phenotype_cache.h"

namespace cambrian {

// Shows the creatures of the newest finished generation, or the starred ones, as tiles. A click or
// the arrow keys display a creature. Only visible tiles are expressed and drawn.
class PopulationPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

    std::size_t tiles_drawn() const { return tiles_drawn_; }  // in the last frame
    std::size_t bodies_kept() const { return bodies_.size(); }

private:
    // The data on which the list of tiles depends.
    struct ListedFor {
        std::uint64_t experiment = 0;
        std::size_t generations = 0;
        std::uint64_t stars = 0;
        TileOrder order = TileOrder::kFitness;
        TileFilter filter;

        friend bool operator==(const ListedFor&, const ListedFor&) = default;
    };
    struct TileGrid {
        std::size_t columns = 1;
        ImVec2 tile;  // size of one, in pixels
    };
    static TileGrid grid_in(const ImVec2& room);
    void gather(const FrameContext& frame);
    void draw_tiles(const FrameContext& frame, Requests& out);
    void draw_tile(std::size_t index, const ImVec2& size, const FrameContext& frame, Requests& out);
    void draw_content(const Tile& tile, const Rect& area, const FrameContext& frame);
    void follow_keys(const TileGrid& grid, const FrameContext& frame, Requests& out) const;

    PhenotypeCache bodies_;
    ListedFor listed_for_;
    std::vector<Tile> tiles_;
    bool from_top_ = false;  // whether the list goes to its top
    std::size_t tiles_drawn_ = 0;
};

}  // namespace cambrian
