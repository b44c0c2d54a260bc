#include "studio/panels/cards/notice_strip.h"

#include "studio/widgets/widgets.h"

namespace cambrian {

void NoticeStrip::draw(const FrameContext& frame, Requests& out) {
    if (frame.notice == nullptr) return;
    const bool problem = frame.notice->kind == NoticeKind::kProblem;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + px(4), at.y + 0.5F * ImGui::GetFontSize()},
                                                px(4),
                                                paint(problem ? colors().danger : colors().accent));
    ImGui::Dummy({px(8), ImGui::GetFontSize()});
    ImGui::SameLine(0, px(10));
    const float text_width = ImGui::GetContentRegionAvail().x - px(44);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + text_width);
    ImGui::TextUnformatted(frame.notice->text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - px(26));
    if (push_button("Dismiss", {.look = ButtonLook::kGhost,
                                .icon = Icon::kClose,
                                .label_shown = false,
                                .width = px(26),
                                .height = px(22)}))
        out.ask(DismissNotice{});
}

}  // namespace cambrian
