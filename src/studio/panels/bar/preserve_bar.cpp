#include "studio/panels/bar/preserve_bar.h"

#include "preserve/world_time.h"
#include "studio/panels/bar/bar_reading.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <cmath>

namespace cambrian {
namespace {

void draw_button(const PreserveView& preserve, Requests& out) {
    ButtonStyle style;
    style.look = ButtonLook::kPrimary;
    style.width = px(118);
    style.height = px(34);
    const WithFont font(ui().fonts.strong);
    if (preserve.single) {
        style.width = px(160);
        style.tooltip = "Esc";
        if (push_button("Back to the world", style)) out.ask(ShowWorld{});
        return;
    }
    const bool playing = preserve.picture.playing;
    style.icon = playing ? Icon::kPause : Icon::kPlay;
    style.tooltip = "Space";
    if (push_button(playing ? "Pause" : "Play", style)) out.ask(TogglePlay{});
}

}  // namespace

void draw_preserve_bar(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    draw_button(preserve, out);
    ImGui::SameLine(0, px(24));
    const PreservePicture& picture = preserve.picture;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    float x = at.x;
    const auto reading = [&](const std::string& value, const std::string& name, float least) {
        if (x + px(least) <= at.x + ImGui::GetContentRegionAvail().x)
            x += std::fmax(px(least), draw_reading({x, at.y - px(1)}, value, name) + px(22));
    };
    reading(world_time(picture.tick), "world time", 92);
    reading(fmt::format("{}", picture.residents.size()), "creatures", 84);
    reading(fmt::format("{}", picture.now.lineages), "lineages", 78);
    reading(picture.playing ? fmt::format("{:.1f} ×", picture.factor) : "–", "real time", 78);
    if (!preserve.single) return;
    const float room = at.x + ImGui::GetContentRegionAvail().x - x;
    ImGui::GetWindowDrawList()->AddText({x, at.y + px(7)}, paint(colors().muted),
                                        fit_text("The world goes on meanwhile", room).c_str());
}

}  // namespace cambrian
