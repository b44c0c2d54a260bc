#include "studio/panels/preserve/world_strip.h"

#include "studio/widgets/widgets.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr float kNarrowPaces = 620.0F;

bool world_button(const char* name, Icon icon, const char* hint, bool chosen = false,
                  bool enabled = true) {
    return push_button(name, {.look = chosen ? ButtonLook::kSelected : ButtonLook::kGhost,
                              .icon = icon,
                              .label_shown = false,
                              .width = px(34),
                              .enabled = enabled,
                              .tooltip = hint});
}

void draw_paces(const PreservePicture& picture, Requests& out) {
    const bool narrow = ImGui::GetWindowWidth() < px(kNarrowPaces);
    const auto found = std::find(kPreservePaces.begin(), kPreservePaces.end(), picture.pace);
    const int pressed =
        segmented("pace", {"0.1×", "1×", "4×", narrow ? "Max" : "As fast as it goes"},
                  static_cast<int>(found - kPreservePaces.begin()),
                  {"Slow motion ([)", "Real time ([ and ])", "Four times real time ([ and ])",
                   "As many ticks as the processors compute (])"});
    if (pressed >= 0)
        out.ask(AskPreserve{PacePreserve{kPreservePaces[static_cast<std::size_t>(pressed)]}});
}

}  // namespace

void WorldStrip::draw(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    const bool playing = preserve.picture.playing;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), px(2)));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + px(7));
    if (world_button("Play the world", playing ? Icon::kPause : Icon::kPlay,
                     playing ? "Pause (Space)" : "Play (Space)"))
        out.ask(TogglePlay{});
    ImGui::SameLine();
    if (world_button("One tick of the world", Icon::kStep, "One tick of 1/60 s (.)"))
        out.ask(AskPreserve{StepPreserve{}});
    ImGui::SameLine(0, px(12));
    draw_paces(preserve.picture, out);
    const float feed = px(62);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - feed - px(34) * 2 - px(8));
    if (push_button("Feed",
                    {.look = ButtonLook::kGhost,
                     .width = feed,
                     .tooltip = "Ten plants in the middle of the view; with E or the middle "
                                "button where the mouse points. The light pays."}))
        out.ask(FeedThere{});
    ImGui::SameLine();
    if (world_button("Follow it", Icon::kFollow, "Follow the picked creature (F)", preserve.follow,
                     preserve.picked != nullptr))
        out.ask(FollowPicked{});
    ImGui::SameLine();
    if (world_button("Fit the world", Icon::kFit, "Fit the world into view (Home)"))
        out.ask(FitWorld{});
    ImGui::PopStyleVar();
}

}  // namespace cambrian
