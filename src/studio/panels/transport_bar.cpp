#include "studio/panels/transport_bar.h"

#include "studio/widgets.h"

#include <string>
#include <vector>

namespace cambrian {
namespace {

bool icon_button(const char* name, Icon icon, const char* hint, bool chosen = false) {
    return push_button(name, {.look = chosen ? ButtonLook::kSelected : ButtonLook::kGhost,
                              .icon = icon,
                              .label_shown = false,
                              .width = px(34),
                              .tooltip = hint});
}

void draw_speeds(const FrameContext& frame, Requests& out) {
    static const std::vector<std::string> labels = {"0.1×", "¼×", "½×", "1×",
                                                    "2×",   "4×", "8×", "16×"};
    int chosen = -1;
    for (std::size_t i = 0; i < kPlaybackSpeeds.size(); ++i) {
        if (kPlaybackSpeeds[i] == frame.view.speed) chosen = static_cast<int>(i);
    }
    const int pressed = segmented("speed", labels, chosen);
    if (pressed < 0) return;
    ViewState view = frame.view;
    view.speed = kPlaybackSpeeds[static_cast<std::size_t>(pressed)];
    out.ask(ChangeView{view});
}

}  // namespace

void TransportBar::draw(const FrameContext& frame, Requests& out) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), 0));
    const bool playing = frame.playback.playing();
    if (icon_button("Restart", Icon::kRestart, "Restart (R)")) out.ask(RestartPlayback{});
    ImGui::SameLine();
    if (icon_button("Play", playing ? Icon::kPause : Icon::kPlay,
                    playing ? "Pause the creature (P)" : "Play (P)"))
        out.ask(TogglePlayback{});
    ImGui::SameLine();
    if (icon_button("One tick", Icon::kStep, "One tick of 1/60 s (.)")) out.ask(StepPlayback{});
    ImGui::SameLine(0, px(16));
    draw_speeds(frame, out);
    const float newest_width = px(78);
    const float right = ImGui::GetWindowContentRegionMax().x;
    ImGui::SameLine(right - px(34) * 2 - px(4) * 4 - newest_width);
    const bool newest = frame.view.newest_champion;
    if (push_button("Newest",
                    {.look = newest ? ButtonLook::kSelected : ButtonLook::kGhost,
                     .width = newest_width,
                     .tooltip = "The best of each finished generation takes the stage (N)"}))
        out.ask(ShowNewest{});
    ImGui::SameLine(0, px(12));
    if (icon_button("Follow", Icon::kFollow, "Follow the creature (F)", frame.view.follow)) {
        ViewState view = frame.view;
        view.follow = !view.follow;
        out.ask(ChangeView{view});
    }
    ImGui::SameLine();
    if (icon_button("Fit", Icon::kFit, "Fit the creature into view (Home)")) out.ask(FitView{});
    ImGui::PopStyleVar();
}

}  // namespace cambrian
