#include "studio/panels/cards/file_strip.h"

#include "studio/panels/cards/notice_strip.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kStopWidth = 60.0F;
constexpr float kShareHeight = 4.0F;

std::string words_of_file(const FileProgress& clip) {
    if (clip.stopping) return fmt::format("Giving up {}", clip.name);
    return fmt::format("Saving {}: {} %", clip.name, std::lround(100.0 * clip.share));
}

}  // namespace

void FileStrip::draw(const FrameContext& frame, Requests& out) {
    const FileProgress& clip = frame.files.writing;
    const float room = ImGui::GetContentRegionAvail().x - px(kStopWidth) - px(12);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::TextUnformatted(fit_text(words_of_file(clip), room).c_str());
    const ImVec2 low = {at.x, at.y + ImGui::GetFontSize() + px(6)};
    const auto draw_bar = [&](float width, const Color& color) {
        ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + px(kShareHeight)},
                                                  paint(color), 0.5F * px(kShareHeight));
    };
    draw_bar(room, colors().raised);
    draw_bar(room * static_cast<float>(clip.share), colors().accent);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - px(kStopWidth));
    if (push_button("Stop", {.width = px(kStopWidth), .enabled = !clip.stopping}))
        out.ask(StopFile{});
}

Rect file_strip_place(const FrameContext& frame, const CardSpace& space) {
    const Rect& viewport = space.viewport;
    const float width = std::min(px(380), viewport.width - px(32));
    const float height = px(48);
    const float low = frame.window.notice == nullptr ? viewport.y + viewport.height - px(14)
                                                     : notice_place(frame, space).y - px(8);
    return {std::round(viewport.center().x - 0.5F * width), std::round(low - height),
            std::round(width), height};
}

}  // namespace cambrian
