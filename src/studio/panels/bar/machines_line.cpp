#include "studio/panels/bar/machines_line.h"

#include "studio/machines/machine_words.h"
#include "studio/widgets/widgets.h"

namespace cambrian {

void MachinesLine::draw(const FrameContext& frame, Requests& out) {
    if (frame.machines == nullptr) return;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (ImGui::InvisibleButton("machines", room)) out.ask(ToggleMachines{});
    note_place("machines line");
    const bool hovered = ImGui::IsItemHovered();
    tooltip("The machines that evaluate. Press for their table (Ctrl+M).");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = at.y + 0.5F * room.y;
    const Color mark = troubled(*frame.machines) ? colors().danger : colors().accent;
    list.AddCircleFilled({at.x + px(4), middle}, px(4), paint(mark));
    const WithFont font(ui().fonts.small);
    const std::string words = fit_text(machines_words(*frame.machines), room.x - px(18));
    list.AddText({at.x + px(18), middle - 0.5F * ImGui::GetFontSize()},
                 paint(hovered ? colors().text : colors().muted), words.c_str());
}

}  // namespace cambrian
