#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"

namespace cambrian {

// Draws the menus File, Edit, View and Help on the present line.
void draw_main_menu(const FrameContext& frame, Requests& out);

}  // namespace cambrian
