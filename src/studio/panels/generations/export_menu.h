#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"

namespace cambrian {

// Entries of a menu that write statistics and the plot to files.
void draw_export_items(const FrameContext& frame, Requests& out);
// The same as a pop-up under the last item, once ImGui::OpenPopup(name) opened it.
void draw_export_popup(const char* name, const FrameContext& frame, Requests& out);

}  // namespace cambrian
