#include "studio/panels/notice_strip.h"

#include "studio/widgets.h"

namespace cambrian {

void NoticeStrip::draw(const FrameContext& frame, Requests& out) {
    if (frame.notice == nullptr) return;
    const bool problem = frame.notice->kind == NoticeKind::kProblem;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    list.AddRectFilled(low, {low.x + px(4), low.y + size.y},
                       paint(problem ? colors().danger : colors().accent));
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
