#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"

namespace cambrian {

// Draws menu items that save the statistics and the plot in files.
void draw_export_items(const FrameContext& frame, Requests& out);
// Draws the same items as a popup below the last item, once ImGui::OpenPopup(name) opened it.
void draw_export_popup(const char* name, const FrameContext& frame, Requests& out);

}  // namespace cambrian
