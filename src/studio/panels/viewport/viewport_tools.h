#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"
#include "studio/look/ui_context.h"

namespace cambrian {

// Draws the small buttons in the viewport's upper right corner: ghosts, overlays and help.
void draw_viewport_tools(const FrameContext& frame, const Rect& area, Requests& out);

// Draws what can be done with the creature on display, below its name: evolve it, put it into a
// preserve, save it.
void draw_shown_actions(const FrameContext& frame, const ImVec2& at, Requests& out);

// Returns how the creature on display is seen. Overlays of what is inside a body, and a hand that
// holds it, show it through its skin.
LookMode shown_look(const FrameContext& frame);

}  // namespace cambrian
