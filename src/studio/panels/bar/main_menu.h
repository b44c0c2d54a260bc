#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"

namespace cambrian {

// File, Edit, View and Help as words on the present line, each opening a list.
void draw_main_menu(const FrameContext& frame, Requests& out);

}  // namespace cambrian
