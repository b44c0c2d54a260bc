#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"
#include "studio/look/ui_context.h"

namespace cambrian {

// Ghosts, overlays and help: small buttons in the upper right corner of the viewport.
void draw_viewport_tools(const FrameContext& frame, const Rect& area, Requests& out);

// The ghosts to choose from, in the order of GhostChoice, as lines of a menu.
void ghost_lines(const FrameContext& frame, Requests& out);

}  // namespace cambrian
