#include "studio/frame/help_mark.h"

#include "studio/widgets/widgets.h"

namespace cambrian {
namespace {

constexpr float kMarkWidth = 24.0F;

}  // namespace

void help_mark(const char* page, Requests& out) {
    if (push_button("? " + std::string(page), {.look = ButtonLook::kGhost,
                                               .icon = Icon::kHelp,
                                               .label_shown = false,
                                               .width = px(kMarkWidth),
                                               .height = px(kHelpMarkHeight),
                                               .tooltip = "Open the help page of this panel"}))
        out.ask(ShowHelp{page});
}

void place_title(const std::string& title, const char* page, Requests& out) {
    const ImVec2 corner = ImGui::GetCursorPos();
    const float lower = 0.5F * (ImGui::GetFrameHeight() - px(kHelpMarkHeight));
    ImGui::SetCursorPos({ImGui::GetWindowContentRegionMax().x - px(kMarkWidth), corner.y + lower});
    help_mark(page, out);
    ImGui::SetCursorPos(corner);
    ImGui::AlignTextToFramePadding();
    const bool focused = ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows);
    const WithTextColor color(focused ? colors().accent : colors().text);
    panel_title(title);
}

}  // namespace cambrian
