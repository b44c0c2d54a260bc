#include "studio/ui_context.h"

#include "core/assert.h"

namespace cambrian {

UiContext& ui() {
    auto* context = static_cast<UiContext*>(ImGui::GetIO().UserData);
    CAMBRIAN_ASSERT(context != nullptr, "the ImGui host sets io.UserData");
    return *context;
}

void note_place(const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    ui().places[name] = {low.x, low.y, size.x, size.y};
}

}  // namespace cambrian
