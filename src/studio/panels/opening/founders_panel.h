#pragma once

#include "render/space_camera.h"
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
    std::size_t row_of(std::size_t place) const;
    void place_in_space(const FounderCrowd& crowd);
    void build_space(const FrameContext& frame);
    // Returns how far a creature in space is moved from where its trial has it.
    Vec3 shift_of(std::size_t place, const FounderCrowd& crowd) const;
    // Returns where the canvas has the middle of a creature, and the highest point over it.
    Vec2 middle_of(std::size_t place, const FounderCrowd& crowd) const;
    Vec2 top_of(std::size_t place, const FounderCrowd& crowd) const;
    Vec2 stand(std::size_t place) const;
    // Returns where a creature is drawn beside where its trial has it.
    Vec2 shift_in_row(std::size_t place, double x, const FounderCrowd& crowd) const;
    // Returns the place of a row whose stand is nearest.
    std::size_t nearest_in(const Row& row, double x) const;
    // Returns the height of a row's ground above its lift, in m: around each creature that of its
    // own trial.
    double ground_of_row(const Row& row, double x, const FounderCrowd& crowd) const;
    GroundShape shape_of_row(const Row& row, const FounderCrowd& crowd) const;
    void add_relief(const Row& row, double top, const Color& color, const FounderCrowd& crowd);
    void build_scene(const FrameContext& frame);
    void add_row(const Row& row, std::size_t number, const FrameContext& frame);
    void add_founder(std::size_t place, const FrameContext& frame);
    void draw_words(const FrameContext& frame) const;
    void draw_choice(const FrameContext& frame) const;
    std::size_t nearest(const Vec2& point, const FounderCrowd& crowd) const;

    SceneCanvas canvas_;
    SpaceCamera space_camera_;
    bool in_space_ = false;  // whether the creatures live in three dimensions
    std::vector<Row> rows_;  // front to back
    double slot_ = 1.0;      // m between two creatures of a row
};

}  // namespace cambrian
