#include "studio/panels/bar/main_menu.h"

#include "studio/actions/action_menu.h"
#include "studio/widgets/keyboard_focus.h"
#include "studio/widgets/widgets.h"

#include <array>
#include <cfloat>

namespace cambrian {
namespace {

struct Menu {
    const char* title;
    const char* lines;  // see action_items()
};
constexpr std::array kMenus = {
    Menu{"File",
         "start open samples previous-run | new-preserve add-file keep-preserve close-preserve | "
         "save-creature save-clip save-experiment save-settings | "
         "save-run-page save-film save-race export-* | screenshot save-seen copy-picture | "
         "compare machines | quit"},
    Menu{"Edit",
         "undo redo | draw-creature draw-new draw-ground | palette find-setting | new-run-* "
         "evolve-shown"},
    Menu{"View",
         "pick-by-hand | panel-* | follow newest-always fit | side-* | overlay-* | look-* | "
         "scenery-* | "
         "ghosts-* | rival | full-screen present | theme size-larger size-smaller size-100"},
    Menu{"Help", "help palette keys tour | about"}};

bool any_menu_open() {
    for (const Menu& menu : kMenus) {
        if (ImGui::IsPopupOpen(menu.title)) return true;
    }
    return false;
}

}  // namespace

void draw_main_menu(const FrameContext& frame, Requests& out) {
    const bool browsing = any_menu_open();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(2), px(8)));
    for (const Menu& menu : kMenus) {
        ButtonStyle style;
        style.look = ImGui::IsPopupOpen(menu.title) ? ButtonLook::kSelected : ButtonLook::kGhost;
        style.width = ImGui::CalcTextSize(menu.title).x + px(20);
        style.height = px(34);
        const bool pressed = push_button(menu.title, style);
        const bool slid_over =
            browsing && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByPopup);
        if (pressed || slid_over) ImGui::OpenPopup(menu.title);
        const ImVec2 below = {ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + px(4)};
        ImGui::SameLine();
        ImGui::SetNextWindowPos(below);
        const float room = ImGui::GetIO().DisplaySize.y - below.y - px(8);
        ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, room});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(10), px(8)));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(18), px(8)));
        if (ImGui::BeginPopup(menu.title)) {
            begin_focus_layer();
            action_items(menu.lines, frame, out);
            ImGui::EndPopup();
        }
        ImGui::PopStyleVar(2);
    }
    ImGui::PopStyleVar();
    ImGui::NewLine();
    ImGui::SameLine();
}

}  // namespace cambrian
