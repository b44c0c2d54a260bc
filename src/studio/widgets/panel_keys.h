#pragma once

#include <imgui.h>

namespace cambrian {

// Returns whether one of Dear ImGui's keys was pressed in this frame while no text is being typed.
inline bool panel_key(ImGuiKey key) {
    const int index = ImGui::GetKeyIndex(key);
    return index >= 0 && !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(index);
}

}  // namespace cambrian
