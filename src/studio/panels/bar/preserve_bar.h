#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"

namespace cambrian {

// Draws the bar's controls and numbers while a preserve is open.
void draw_preserve_bar(const FrameContext& frame, Requests& out);

}  // namespace cambrian
