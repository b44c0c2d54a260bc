#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Menus, Evolve or Pause, one generation, and how far the generation in flight is.
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
