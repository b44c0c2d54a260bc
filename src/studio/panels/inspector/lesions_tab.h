#pragma once

#include "studio/frame/panel.h"

#include <cstddef>
#include <optional>

namespace cambrian {

// Shows what is left of the creature's score without each of its parts, joints, neurons, links,
// sensors and organs, and prunes what costs nothing.
class LesionsTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void draw_controls(const FrameContext& frame, Requests& out) const;
    void draw_table(const LesionTable& table, const FrameContext& frame, Requests& out);
    void draw_row(const LesionTable& table, std::size_t row, const FrameContext& frame,
                  Requests& out);

    const LesionTable* shown_ = nullptr;  // compared only
    std::optional<std::size_t> chosen_;   // row
};

}  // namespace cambrian
