#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"

namespace cambrian {

// Shows what the displayed creature loses if its senses read their best constants, or offers to
// find out.
void draw_senses(const FrameContext& frame, Requests& out);

}  // namespace cambrian
