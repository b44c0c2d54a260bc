#pragma once

#include <imgui.h>

namespace cambrian {

// Whether a key of Dear ImGui's own list went down this frame, while no text is typed.
inline bool panel_key(ImGuiKey key) {
    const int index = ImGui::GetKeyIndex(key);
    return index >= 0 && !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(index);
}

}  // namespace cambrian
