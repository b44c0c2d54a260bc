#include "studio/actions/action_menu.h"

#include "studio/actions/action.h"
#include "studio/widgets/widgets.h"

#include <sstream>

namespace cambrian {
namespace {

constexpr float kWidestMenu = 360.0F;

void draw_item(const FoundAction& found, const FrameContext& frame, Requests& out) {
    const Action& action = *found.action;
    const std::string keys = present_keys(action, frame);
    const bool chosen = action.chosen && action.chosen(frame);
    if (menu_item(action.label.c_str(), keys.empty() ? nullptr : keys.c_str(), found.enabled,
                  chosen))
        action.ask(frame, out);
    if (!action.help.empty()) tooltip(action.help);
}

}  // namespace

void action_items(const std::string& ids, const FrameContext& frame, Requests& out) {
    std::istringstream words(ids);
    for (std::string id; words >> id;) {
        if (id == "|") {
            ImGui::Separator();
        } else if (id.ends_with('*')) {
            for (const FoundAction& found : present_actions(frame)) {
                if (found.action->id.starts_with(id.substr(0, id.size() - 1)))
                    draw_item(found, frame, out);
            }
        } else if (const FoundAction found = find_action(id, frame); found.action != nullptr) {
            draw_item(found, frame, out);
        }
    }
}

void action_popup(const char* name, const std::string& ids, const FrameContext& frame,
                  Requests& out) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const bool fits = high.x > px(kWidestMenu);
    ImGui::SetNextWindowPos({fits ? high.x : low.x, high.y + px(4)}, ImGuiCond_Always,
                            {fits ? 1.0F : 0.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(10), px(8)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(18), px(8)));
    if (ImGui::BeginPopup(name)) {
        action_items(ids, frame, out);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

}  // namespace cambrian
