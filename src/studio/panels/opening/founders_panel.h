#pragma once

#include "studio/frame/panel.h"
#include "studio/host/scene_canvas.h"

#include <cstddef>
#include <vector>

namespace cambrian {

// Shows the founders of a run in one world before the run begins, in rows behind each other. Each
// moves in a trial of its own; a click on one describes it in the inspector.
class FoundersPanel final : public Panel {
public:
    // Without a renderer, as in tests, the panel works but draws no scene.
    explicit FoundersPanel(Renderer* renderer) { canvas_.renderer = renderer; }

    void draw(const FrameContext& frame, Requests& out) override;

private:
    struct Row {
        std::size_t first = 0;  // place of its first creature
        std::size_t count = 0;
        double lift = 0.0;  // m above the ground, or above the middle of the view
    };

    void place_rows(const FounderCrowd& crowd);
    Vec2 stand(std::size_t place) const;
    void build_scene(const FrameContext& frame);
    void add_row(const Row& row, std::size_t number, const FrameContext& frame);
    void add_founder(std::size_t place, const FrameContext& frame);
    void draw_words(const FrameContext& frame) const;
    void draw_choice(const FrameContext& frame) const;
    std::size_t nearest(const Vec2& point, const FounderCrowd& crowd) const;

    SceneCanvas canvas_;
    std::vector<Row> rows_;  // front to back
    double slot_ = 1.0;      // m between two creatures of a row
};

}  // namespace cambrian
