#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Shows what is left of the creature's score without each of its parts, joints, neurons, links,
// sensors and organs, plays it so, and prunes what costs nothing.
class LesionsTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    static void draw_controls(const FrameContext& frame, Requests& out);
    static void draw_table(const LesionTable& table, const FrameContext& frame, Requests& out);
};

}  // namespace cambrian
