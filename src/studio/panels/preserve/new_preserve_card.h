#pragma once

#include "studio/frame/panel.h"

#include <cstddef>
#include <filesystem>

namespace cambrian {

// The card with which a preserve is begun.
class NewPreserveCard final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void follow_plan(const PlanPreserve& plan);
    void move_by_keys(const PreserveCardView& card);
    bool draw_choice(std::size_t index, bool possible);
    void draw_edges(bool possible);
    void draw_ground(bool possible);

    std::size_t chosen_ = 4;          // index of the choice
    bool wraps_ = false;              // edges meet
    std::size_t ground_ = 0;          // index of the ground of a meadow
    std::filesystem::path settings_;  // file of the plan at the last frame
};

}  // namespace cambrian
