#include "studio/panels/generations/export_menu.h"

#include "studio/widgets/widgets.h"

namespace cambrian {

void draw_export_items(const FrameContext& frame, Requests& out) {
    const bool any = !frame.experiment.snapshot.history.empty();
    if (menu_item("Export statistics as CSV…", "Ctrl+E", any))
        out.ask(OpenFilePanel{FileTask::kSaveStatistics});
    if (menu_item("Export plot as PNG, 1280 × 720…", "Ctrl+Shift+E", any))
        out.ask(OpenFilePanel{FileTask::kSavePlot});
    if (menu_item("Export plot as PNG, 1920 × 1080…", nullptr, any))
        out.ask(OpenFilePanel{FileTask::kSavePlot, {1920, 1080}});
}

void draw_export_popup(const char* name, const FrameContext& frame, Requests& out) {
    const ImVec2 corner = ImGui::GetItemRectMax();
    ImGui::SetNextWindowPos({corner.x, corner.y + px(4)}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(10), px(8)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(18), px(8)));
    if (ImGui::BeginPopup(name)) {
        draw_export_items(frame, out);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

}  // namespace cambrian
