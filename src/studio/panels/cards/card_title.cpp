#include "studio/panels/cards/card_title.h"

#include "studio/frame/help_mark.h"
#include "studio/widgets/widgets.h"

namespace cambrian {
namespace {

constexpr float kLineHeight = 30.0F;
constexpr float kCloseWidth = 34.0F;

// Returns the offset at which something of a height is in the middle of the line.
float middle_offset(float height) {
    return 0.5F * (px(kLineHeight) - height);
}

}  // namespace

bool card_title(const std::string& title, const char* close, const char* page, Requests& out) {
    const ImVec2 corner = ImGui::GetCursorPos();
    const float close_x = ImGui::GetWindowContentRegionMax().x - px(kCloseWidth);
    {
        const WithFont font(ui().fonts.title);
        ImGui::SetCursorPosY(corner.y + middle_offset(ImGui::GetFontSize()));
        ImGui::TextUnformatted(title.c_str());
    }
    if (page != nullptr) {
        ImGui::SetCursorPos(
            {close_x - px(kHelpMarkRoom), corner.y + middle_offset(px(kHelpMarkHeight))});
        help_mark(page, out);
    }
    ImGui::SetCursorPos({close_x, corner.y});
    return push_button(close, {.look = ButtonLook::kGhost,
                               .icon = Icon::kClose,
                               .label_shown = false,
                               .width = px(kCloseWidth),
                               .height = px(kLineHeight),
                               .tooltip = "Close (Esc)"});
}

}  // namespace cambrian
