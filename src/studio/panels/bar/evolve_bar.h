#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// The bar with the menus, Evolve or Pause, a single generation, and the progress of the present
// generation.
class EvolveBar final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    static void draw_modes(const FrameContext& frame, Requests& out);
    static void draw_breeding(const FrameContext& frame, Requests& out);
    static void draw_picking(const FrameContext& frame);
    static void draw_buttons(const FrameContext& frame, Requests& out);
    static void draw_numbers(const FrameContext& frame);
};

}  // namespace cambrian
