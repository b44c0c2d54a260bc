#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"

#include <string>

namespace cambrian {

// Draws menu lines of the actions whose ids are in the text. "|" draws a line between groups, and
// "look-*" all actions whose id begins with "look-".
void action_items(const std::string& ids, const FrameContext& frame, Requests& out);
// Draws them as a menu that hangs from the last item, from its right end where there is room, once
// ImGui::OpenPopup(name) opened it.
void action_popup(const char* name, const std::string& ids, const FrameContext& frame,
                  Requests& out);

}  // namespace cambrian
