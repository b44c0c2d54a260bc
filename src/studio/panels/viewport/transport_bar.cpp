#include "studio/panels/viewport/transport_bar.h"

#include "core/text/pretty_text.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr float kNarrowBar = 640.0F;       // width below which the speeds do not all fit
constexpr float kLeastWithSteps = 400.0F;  // narrower bars leave single ticks to the keys

bool is_narrow_bar() {
    return ImGui::GetWindowWidth() < px(kNarrowBar);
}

bool icon_button(const char* name, Icon icon, const char* hint, bool chosen = false) {
    return push_button(name, {.look = chosen ? ButtonLook::kSelected : ButtonLook::kGhost,
                              .icon = icon,
                              .label_shown = false,
                              .width = px(34),
                              .tooltip = hint});
}

// Returns a tick's time in the words of the clock above the creature.
std::string moment_text(std::uint64_t tick, std::uint64_t settled) {
    if (tick < settled) return "settling";
    return fmt::format("{:.2f} s", static_cast<double>(tick - settled) * kBrainTick);
}

// Draws the time bar of the trial. A click or drag seeks a tick.
void draw_time_bar(const FrameContext& frame, Requests& out) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, px(12)};
    ImGui::InvisibleButton("time bar", size);
    note_place("time bar");
    const Playback& playback = frame.viewer.playback;
    const auto length = static_cast<float>(std::max<std::uint64_t>(1, playback.length()));
    const std::uint64_t settled = playback.empty() ? 0 : playback.trial().settle_ticks();
    const bool aimed = ImGui::IsItemHovered() || ImGui::IsItemActive();
    const float share = std::clamp((ImGui::GetIO().MousePos.x - low.x) / size.x, 0.0F, 1.0F);
    const auto aimed_tick = static_cast<std::uint64_t>(std::lround(share * length));
    if (ImGui::IsItemActive() && aimed_tick != playback.tick_shown())
        out.ask(SeekPlayback{aimed_tick});

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = low.y + 0.5F * size.y;
    const float half = aimed ? px(3) : px(2);
    const auto stretch = [&](float from, float to, const Color& color) {
        list.AddRectFilled({low.x + from * size.x, middle - half},
                           {low.x + to * size.x, middle + half}, paint(color), half);
    };
    const float now = static_cast<float>(playback.tick_shown()) / length;
    stretch(0.0F, 1.0F, aimed ? colors().hovered : colors().raised);
    stretch(0.0F, now, mix(colors().raised, colors().accent, 0.7F));
    const float start = low.x + size.x * static_cast<float>(settled) / length;
    if (settled > 0)
        list.AddLine({start, low.y + px(1)}, {start, low.y + size.y - px(1)}, paint(colors().faint),
                     px(1));
    list.AddCircleFilled({low.x + now * size.x, middle}, aimed ? px(6) : px(4),
                         paint(colors().accent));
    if (aimed)
        tooltip(fmt::format(
            "Go to {}. Drag to go through the trial; the mark is where the test begins.",
            moment_text(aimed_tick, settled)));
}

// Draws the speeds as a list, for narrow bars. Returns the index chosen, or -1.
int choose_speed(const std::vector<std::string>& labels, int chosen) {
    int pressed = -1;
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + px(2));
    const std::string shown = chosen < 0 ? "" : labels[static_cast<std::size_t>(chosen)];
    if (begin_choice("##speed", shown, px(64))) {
        for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
            if (choice_line(labels[static_cast<std::size_t>(i)].c_str(), i == chosen)) pressed = i;
        }
        ImGui::EndCombo();
    }
    note_place("speed");
    tooltip("The playback speed ([ and ])");
    return pressed;
}

void draw_speeds(const FrameContext& frame, Requests& out) {
    static const std::vector<std::string> labels = {"0.1×", "¼×", "½×", "1×",
                                                    "2×",   "4×", "8×", "16×"};
    int chosen = -1;
    for (std::size_t i = 0; i < kPlaybackSpeeds.size(); ++i) {
        if (kPlaybackSpeeds[i] == frame.view.speed) chosen = static_cast<int>(i);
    }
    const int pressed =
        is_narrow_bar() ? choose_speed(labels, chosen) : segmented("speed", labels, chosen);
    if (pressed < 0) return;
    ViewState view = frame.view;
    view.speed = kPlaybackSpeeds[static_cast<std::size_t>(pressed)];
    out.ask(ChangeView{view});
}

// Draws the button "Newest" at the right. A viewer has no evolution and no such button.
void draw_newest(const FrameContext& frame, Requests& out) {
    const float width = px(is_narrow_bar() ? 66 : 78);
    const float after = px(34) * 2 + px(4) * 4;
    const float right = ImGui::GetWindowContentRegionMax().x;
    if (frame.window.viewer_only) return ImGui::SameLine(right - after + px(12));
    ImGui::SameLine(right - after - width);
    const bool newest = frame.view.newest_champion;
    if (push_button("Newest", {.look = newest ? ButtonLook::kSelected : ButtonLook::kGhost,
                               .width = width,
                               .tooltip = "The best of each finished generation is displayed (N)"}))
        out.ask(ShowNewest{});
    ImGui::SameLine(0, px(12));
}

}  // namespace

void TransportBar::draw(const FrameContext& frame, Requests& out) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), px(2)));
    draw_time_bar(frame, out);
    const bool playing = frame.viewer.playback.pace().playing;
    if (icon_button("Restart", Icon::kRestart, "Restart (R)")) out.ask(RestartPlayback{});
    ImGui::SameLine();
    const bool has_steps = ImGui::GetWindowWidth() > px(kLeastWithSteps);
    if (has_steps && icon_button("Back one tick", Icon::kStepBack, "Back one tick of 1/60 s (,)"))
        out.ask(StepPlaybackBack{});
    if (has_steps) ImGui::SameLine();
    if (icon_button("Play", playing ? Icon::kPause : Icon::kPlay,
                    playing ? "Pause the creature (P)" : "Play (P)"))
        out.ask(TogglePlayback{});
    if (has_steps) ImGui::SameLine();
    if (has_steps && icon_button("One tick", Icon::kStep, "One tick of 1/60 s (.)"))
        out.ask(StepPlayback{});
    ImGui::SameLine(0, px(is_narrow_bar() ? 8 : 16));
    draw_speeds(frame, out);
    draw_newest(frame, out);
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
