#include "studio/panels/cards/notice_strip.h"

#include "studio/widgets/widgets.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

void NoticeStrip::draw(const FrameContext& frame, Requests& out) {
    if (frame.window.notice == nullptr) return;
    const NoticeKind kind = frame.window.notice->kind;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 middle = {at.x + px(4), at.y + 0.5F * ImGui::GetFontSize()};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (kind == NoticeKind::kFeat) {
        draw_icon(list, Icon::kStar, middle, px(18), colors().plot_best);
    } else {
        list.AddCircleFilled(
            middle, px(4), paint(kind == NoticeKind::kProblem ? colors().danger : colors().accent));
    }
    ImGui::Dummy({px(8), ImGui::GetFontSize()});
    ImGui::SameLine(0, px(10));
    const float text_width = ImGui::GetContentRegionAvail().x - px(44);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + text_width);
    ImGui::TextUnformatted(frame.window.notice->text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - px(26));
    if (push_button("Dismiss", {.look = ButtonLook::kGhost,
                                .icon = Icon::kClose,
                                .label_shown = false,
                                .width = px(26),
                                .height = px(22)}))
        out.ask(DismissNotice{});
}

Rect notice_place(const FrameContext& frame, const CardSpace& space) {
    const Rect& viewport = space.viewport;
    const float wide = std::min(px(620), viewport.width - px(32));
    const ImVec2 size =
        ImGui::CalcTextSize(frame.window.notice->text.c_str(), nullptr, false, wide - px(94));
    const float height = std::min(size.y + px(20), viewport.height);
    const float width = std::min(wide, size.x + px(104));
    return {std::round(viewport.center().x - 0.5F * width),
            std::round(viewport.y + viewport.height - height - px(14)), std::round(width),
            std::round(height)};
}

}  // namespace cambrian
